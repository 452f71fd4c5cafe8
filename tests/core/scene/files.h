#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace chiaro::test {

/// Writes a small file and its folder; without the care, and the wait for the disk, of writeFileAtomically.
inline void writeBytes(const std::filesystem::path& path, std::string_view bytes) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

}  // namespace chiaro::test
