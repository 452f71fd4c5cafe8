#include "app/cli/overwrite_flag.h"

#include "core/base/atomic_file.h"

namespace chiaro::cli {

void OverwriteFlag::addTo(CLI::App& command) {
    command.add_flag("--overwrite", m_isGiven, "Replace files that are there already");
}

void OverwriteFlag::check(const std::vector<std::filesystem::path>& files, const std::string& orElse) const {
    const std::string replace = "--overwrite to replace it";
    checkOutputs(
        files, m_isGiven,
        "choose another name" + (orElse.empty() ? " or " + replace : ", " + replace + ", or " + orElse));
}

}  // namespace chiaro::cli
