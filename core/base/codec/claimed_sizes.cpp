#include "core/base/codec/claimed_sizes.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <string>

namespace chiaro {

bool pngChunksFit(const std::filesystem::path& path) {
    constexpr std::uint64_t signature = 8, frame = 12;  // length, type and check sum
    std::error_code ignored;
    const std::uint64_t size = std::filesystem::file_size(path, ignored);
    std::ifstream file(path, std::ios::binary);
    for (std::uint64_t at = signature; at + frame <= size;) {
        std::array<unsigned char, 8> head{};
        file.seekg(std::streamoff(at));
        if (!file.read(reinterpret_cast<char*>(head.data()), head.size())) return false;
        const std::uint64_t length = std::uint64_t(head[0]) << 24 | head[1] << 16 | head[2] << 8 | head[3];
        if (head[4] == 'I' && head[5] == 'E' && head[6] == 'N' && head[7] == 'D') return true;
        if (length > size - at - frame) return false;
        at += frame + length;
    }
    return true;
}

bool openExrHeaderFits(const std::filesystem::path& path) {
    constexpr std::uint64_t rowsAPart = 256;  // of any compression, with eight bytes to tell where it is
    std::error_code ignored;
    const std::uint64_t size = std::filesystem::file_size(path, ignored);
    std::ifstream file(path, std::ios::binary);
    const auto number = [&] {
        std::array<unsigned char, 4> bytes{};
        file.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
        return std::uint32_t(bytes[0] | bytes[1] << 8 | bytes[2] << 16) | std::uint32_t(bytes[3]) << 24;
    };
    file.seekg(8);
    for (std::string name, type; std::getline(file, name, '\0') && !name.empty();) {
        if (!std::getline(file, type, '\0')) return false;
        const std::uint64_t length = number();
        const auto begin = std::uint64_t(file.tellg());
        if (!file || length > size - begin) return false;
        if (name == "dataWindow" && length == 16) {
            number();
            const std::int64_t top = std::int32_t(number());
            number();
            const std::int64_t rows = std::int32_t(number()) - top + 1;
            if (rows > 0 && std::uint64_t(rows) / rowsAPart * 8 > size) return false;
        }
        file.seekg(std::streamoff(begin + length));
    }
    return bool(file);
}

}  // namespace chiaro
