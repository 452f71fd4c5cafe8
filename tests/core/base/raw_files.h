#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

/// Picture files put together byte by byte, for what our own writer never writes.
namespace chiaro::test {

using Bytes = std::string;

inline void save(const std::filesystem::path& path, const Bytes& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

inline Bytes load(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return Bytes(std::istreambuf_iterator<char>(stream), {});
}

inline Bytes bigEndian(std::uint32_t value) {
    return {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
}

inline Bytes littleEndian(std::uint32_t value, int size) {
    Bytes bytes;
    for (int i = 0; i < size; ++i) bytes += char(value >> (8 * i));
    return bytes;
}

inline Bytes pngChunk(const Bytes& type, const Bytes& data) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char c : type + data) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320u : 0u);
    }
    return bigEndian(std::uint32_t(data.size())) + type + data + bigEndian(~crc);
}

/// zlib's format with one block that is stored, not compressed.
inline Bytes zlibStored(const Bytes& data) {
    std::uint32_t a = 1, b = 0;
    for (const char c : data) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    const auto size = std::uint32_t(data.size());
    return Bytes("\x78\x01\x01", 3) + littleEndian(size, 2) + littleEndian(~size & 0xFFFF, 2) + data +
           bigEndian(b << 16 | a);
}

enum class PngColor { Grey = 0, Rgb = 2, Palette = 3, GreyAlpha = 4, RgbAlpha = 6 };

/// `rows` hold each row's bytes, without the filter byte; `extra` are chunks before the pixels.
inline Bytes png(std::uint32_t width, std::uint32_t height, int bits, PngColor color,
                 const std::vector<Bytes>& rows, const Bytes& extra = {}) {
    Bytes raw;
    for (const Bytes& row : rows) raw += Bytes(1, '\0') + row;
    const Bytes header =
        bigEndian(width) + bigEndian(height) + Bytes{char(bits), char(color), '\0', '\0', '\0'};
    return Bytes("\x89PNG\r\n\x1a\n") + pngChunk("IHDR", header) + extra + pngChunk("IDAT", zlibStored(raw)) +
           pngChunk("IEND", {});
}

struct TiffPicture {
    std::uint32_t width, height;
    std::uint32_t channels = 3;
    std::uint32_t photometric = 2;  ///< 1 grey, 2 RGB, 5 CMYK
    std::uint32_t orientation = 1;
    Bytes pixels;  ///< 8 bits a channel, interleaved
};

inline Bytes tiff(const TiffPicture& picture) {
    const std::uint32_t pixelsAt = 8;
    const std::uint32_t bitsAt = pixelsAt + std::uint32_t(picture.pixels.size());
    const std::uint32_t directoryAt = bitsAt + 8;
    struct Tag {
        std::uint32_t id, type, count, value;
    };
    const std::uint32_t bits = picture.channels <= 2 ? 8 | 8 << 16 : bitsAt;
    const std::vector<Tag> tags{
        {256, 4, 1, picture.width},       {257, 4, 1, picture.height},
        {258, 3, picture.channels, bits}, {259, 3, 1, 1},
        {262, 3, 1, picture.photometric}, {273, 4, 1, pixelsAt},
        {274, 3, 1, picture.orientation}, {277, 3, 1, picture.channels},
        {278, 4, 1, picture.height},      {279, 4, 1, std::uint32_t(picture.pixels.size())}};
    Bytes file = Bytes("II*\0", 4) + littleEndian(directoryAt, 4) + picture.pixels;
    for (int i = 0; i < 4; ++i) file += littleEndian(8, 2);
    file += littleEndian(std::uint32_t(tags.size()), 2);
    for (const Tag& tag : tags)
        file += littleEndian(tag.id, 2) + littleEndian(tag.type, 2) + littleEndian(tag.count, 4) +
                littleEndian(tag.value, 4);
    return file + littleEndian(0, 4);
}

}  // namespace chiaro::test
