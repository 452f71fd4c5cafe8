#include "app/cli/farm/engine.h"

#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace chiaro::cli::farm {

std::span<const Engine> engines() {
    static const std::vector<Engine> table{slurmEngine(), localEngine()};
    return table;
}

const Engine& engine(const std::string& key) {
    std::vector<std::string> keys;
    for (const Engine& one : engines()) {
        if (one.key == key) return one;
        keys.push_back(one.key);
    }
    throw Error("engine", "is \"" + key + "\"", fmt::format("choose {}", fmt::join(keys, " or ")));
}

}  // namespace chiaro::cli::farm
