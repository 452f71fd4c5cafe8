#include "core/base/module.h"

#include "core/base/error.h"

#include <dlfcn.h>

namespace chiaro {

namespace fs = std::filesystem;

fs::path companionFile(const std::string& file) {
    std::error_code ignored;
    const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    for (const fs::path& candidate : {folder.parent_path() / "lib" / "chiaro" / file, folder / file})
        if (fs::exists(candidate, ignored)) return candidate;
    return fs::path(CHIARO_MODULE_FOLDER) / file;
}

void* moduleFunction(const std::string& module, const char* function) {
    const fs::path path = companionFile(module + CHIARO_MODULE_SUFFIX);
    // Never closed: its libraries keep threads.
    void* loaded = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* found = loaded ? ::dlsym(loaded, function) : nullptr;
    if (found) return found;
    const char* reason = ::dlerror();
    throw Error(path.string(),
                std::string("could not be loaded (") + (reason ? reason : "no reason given") + ")",
                "install Chiaro again");
}

}  // namespace chiaro
