#include "tests/fuzz/corpus.h"

#include "core/base/atomic_file.h"
#include "tests/support/support.h"

#include <cstdlib>

namespace chiaro::test {

std::vector<std::string> Format::corpus() const {
    std::vector<std::string> files;
    for (const auto& path : filesIn(std::filesystem::path(CHIARO_FUZZ_CORPUS) / name))
        files.push_back(readFile(path, 1 << 20));
    return files;
}

const std::vector<Format>& formats() {
    static const std::vector<Format> all{
        {"png", ".png"},
        {"jpeg", ".jpg"},
        {"tiff", ".tif"},
        {"exr", ".exr"},
        {"webp", ".webp"},
        {"obj", ".obj", Opened::Mesh},
        {"ply", ".ply", Opened::Mesh},
        {"off", ".off", Opened::Mesh},
        {"stl", ".stl", Opened::Mesh},
        {"glb", ".glb", Opened::Mesh},
        {"gltf", ".gltf", Opened::Mesh},
        {"chiaro", ".chiaro", Opened::Project},
        {"path", ".json", Opened::Path},
        {"preset", ".json", Opened::Preset},
    };
    return all;
}

std::size_t rounds(std::size_t quick, std::size_t thorough) {
    const char* const wanted = std::getenv("CHIARO_LONG_TESTS");
    return wanted && *wanted && std::string_view(wanted) != "0" ? thorough : quick;
}

}  // namespace chiaro::test
