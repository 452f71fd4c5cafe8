// A libFuzzer program for one of our readers of text; CHIARO_FUZZ_PARSER is its name.

#include "core/base/error.h"
#include "core/gradient/color_path.h"
#include "core/project/animation.h"
#include "core/project/project.h"

#include <cstdint>
#include <cstdlib>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

namespace {

using namespace chiaro;

/// A file in memory, since these readers want a path.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes) {
        if (::write(m_descriptor, bytes.data(), bytes.size()) != ssize_t(bytes.size())) std::abort();
    }
    ~MemoryFile() { ::close(m_descriptor); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::string path() const { return "/proc/self/fd/" + std::to_string(m_descriptor); }

private:
    int m_descriptor = ::memfd_create("fuzz", 0);
};

[[maybe_unused]] void parseProject(std::string_view bytes) {
    project::readProject(MemoryFile(bytes).path());
}

[[maybe_unused]] void parsePath(std::string_view bytes) {
    const scene::Path path = project::readPath(MemoryFile(bytes).path());
    path.at(1.5, {});
}

[[maybe_unused]] void parseStops(std::string_view bytes) {
    const gradient::ColorPath path = gradient::parseColorPath(bytes);
    path.at(0.3f);
    gradient::parseColorPath(gradient::colorPathText(path));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        CHIARO_FUZZ_PARSER({reinterpret_cast<const char*>(data), size});
    } catch (const Error&) {
    }
    return 0;
}
