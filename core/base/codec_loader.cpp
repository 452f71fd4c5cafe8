#include "core/base/codec/codec.h"
#include "core/base/error.h"

#include <dlfcn.h>

namespace chiaro {

namespace fs = std::filesystem;

namespace {

/// lib/chiaro beside the program's bin, as built and as installed; else where this build put it.
fs::path modulePath() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path beside = program.parent_path().parent_path() / "lib" / "chiaro" / CHIARO_CODEC_NAME;
    return fs::exists(beside, ignored) ? beside : fs::path(CHIARO_CODEC_FOLDER) / CHIARO_CODEC_NAME;
}

const ImageCodec& load() {
    const fs::path path = modulePath();
    // Never closed: its library keeps threads.
    void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* entry = module ? ::dlsym(module, "chiaroImageCodec") : nullptr;
    if (!entry) {
        const char* reason = ::dlerror();
        throw Error(path.string(),
                    std::string("could not be loaded (") + (reason ? reason : "no reason given") + ")",
                    "install Chiaro again");
    }
    return *reinterpret_cast<const ImageCodec* (*)()>(entry)();
}

}  // namespace

const ImageCodec& imageCodec() {
    static const ImageCodec& codec = load();
    return codec;
}

}  // namespace chiaro
