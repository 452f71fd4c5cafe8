#include "core/base/module.h"

#include "core/base/error.h"

#include <dlfcn.h>

namespace chiaro {

namespace fs = std::filesystem;

namespace {

fs::path modulePath(const std::string& file) {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path beside = program.parent_path().parent_path() / "lib" / "chiaro" / file;
    return fs::exists(beside, ignored) ? beside : fs::path(CHIARO_MODULE_FOLDER) / file;
}

}  // namespace

void* moduleFunction(const std::string& module, const char* function) {
    const fs::path path = modulePath(module + CHIARO_MODULE_SUFFIX);
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
