#include "core/base/resources.h"

#include "core/base/error.h"

#include <cstdlib>

namespace chiaro {

namespace fs = std::filesystem;

namespace {

/// Where the installed program's data is; a build has its own as well.
fs::path shareFolder() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    return program.parent_path().parent_path() / "share" / "chiaro";
}

}  // namespace

fs::path resourceFolder() {
    std::error_code ignored;
    if (const char* chosen = std::getenv("CHIARO_RESOURCES"); chosen && *chosen) {
        if (fs::is_directory(chosen, ignored)) return chosen;
        throw Error(chosen, "is not a folder", "set CHIARO_RESOURCES to the folder that holds demo/");
    }
    const fs::path installed = shareFolder();
    for (const fs::path& candidate : {installed, fs::path(CHIARO_SOURCE_RESOURCES)})
        if (fs::is_directory(candidate / "demo", ignored)) return candidate;
    throw Error(installed.string(), "the demo's files are missing",
                "install Chiaro again or set CHIARO_RESOURCES");
}

fs::path pageFile() {
    const fs::path name = fs::path("page") / "relightable.html";
    std::error_code ignored;
    if (const char* chosen = std::getenv("CHIARO_RESOURCES"); chosen && *chosen)
        if (fs::exists(chosen / name, ignored)) return chosen / name;
    return shareFolder() / name;
}

}  // namespace chiaro
