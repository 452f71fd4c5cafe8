#include "tests/core/base/raw_files.h"
#include "tests/fuzz/bombs.h"

#include <spdlog/fmt/fmt.h>

#include <bit>
#include <zlib.h>

namespace chiaro::test {

namespace {

Bytes deflated(const Bytes& data) {
    uLongf size = compressBound(uLong(data.size()));
    Bytes packed(size, '\0');
    compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
              uLong(data.size()), 9);
    packed.resize(size);
    return packed;
}

/// Of `count` zeros, which are never all in memory.
Bytes deflatedZeros(std::size_t count) {
    z_stream stream{};
    deflateInit(&stream, 9);
    Bytes zeros(1 << 20, '\0'), packed, part(1 << 16, '\0');
    while (count > 0 || stream.avail_in > 0) {
        if (stream.avail_in == 0) {
            stream.avail_in = uInt(std::min(count, zeros.size()));
            stream.next_in = reinterpret_cast<Bytef*>(zeros.data());
            count -= stream.avail_in;
        }
        stream.next_out = reinterpret_cast<Bytef*>(part.data());
        stream.avail_out = uInt(part.size());
        deflate(&stream, count == 0 ? Z_FINISH : Z_NO_FLUSH);
        packed.append(part, 0, part.size() - stream.avail_out);
    }
    while (deflate(&stream, Z_FINISH) != Z_STREAM_END) {
        packed.append(part, 0, part.size() - stream.avail_out);
        stream.next_out = reinterpret_cast<Bytef*>(part.data());
        stream.avail_out = uInt(part.size());
    }
    packed.append(part, 0, part.size() - stream.avail_out);
    deflateEnd(&stream);
    return packed;
}

Bytes pngHeader(std::uint32_t width, std::uint32_t height) {
    return Bytes("\x89PNG\r\n\x1a\n") +
           pngChunk("IHDR", bigEndian(width) + bigEndian(height) + Bytes("\x08\x02\0\0\0", 5));
}

Bytes pngOfZeros() {
    return pngHeader(30'000, 3'000) + pngChunk("IDAT", deflatedZeros(3'000 * (3 * 30'000 + 1))) +
           pngChunk("IEND", {});
}

Bytes pngWithText() {
    const Bytes text = pngChunk("zTXt", Bytes("Comment\0\0", 9) + deflatedZeros(400 << 20));
    return png(4, 1, 8, PngColor::Grey, {"abcd"}, text);
}

/// A comment of two gigabytes, or so it says.
Bytes pngChunkOfNothing() {
    return pngHeader(64, 64) + bigEndian(0x7d000000) + "tEXtComment" + Bytes(200, 'x');
}

struct Tag {
    std::uint32_t id, type, count, value;
};

/// A TIFF whose pixels lie at byte 8 and whose directory follows them.
Bytes tiffOf(const std::vector<Tag>& tags, const Bytes& pixels, std::uint32_t next = 0) {
    const std::uint32_t directory = 8 + std::uint32_t(pixels.size() + pixels.size() % 2);
    Bytes file = Bytes("II*\0", 4) + littleEndian(directory, 4) + pixels + Bytes(pixels.size() % 2, '\0') +
                 littleEndian(std::uint32_t(tags.size()), 2);
    for (const Tag& tag : tags)
        file += littleEndian(tag.id, 2) + littleEndian(tag.type, 2) + littleEndian(tag.count, 4) +
                littleEndian(tag.value, 4);
    return file + littleEndian(next, 4);
}

std::vector<Tag> greyTags(std::uint32_t width, std::uint32_t height, std::uint32_t compression,
                          std::size_t size) {
    return {{256, 4, 1, width},       {257, 4, 1, height}, {258, 3, 1, 8},
            {259, 3, 1, compression}, {262, 3, 1, 1},      {273, 4, 1, 8},
            {277, 3, 1, 1},           {278, 4, 1, height}, {279, 4, 1, std::uint32_t(size)}};
}

Bytes tiffOfZeros() {
    const Bytes packed = deflatedZeros(10'000 * 9'990);
    std::vector<Tag> tags = greyTags(10'000, 9'990, 8, packed.size());
    tags[2].value = 32;  // four times as many bytes as there are
    tags.push_back({339, 3, 1, 3});
    return tiffOf(tags, packed);
}

Bytes tiffWithTiles(std::uint32_t side) {
    return tiffOf({{256, 4, 1, 64},
                   {257, 4, 1, 64},
                   {258, 3, 1, 8},
                   {259, 3, 1, 1},
                   {262, 3, 1, 1},
                   {277, 3, 1, 1},
                   {322, 4, 1, side},
                   {323, 4, 1, side},
                   {324, 4, 1, 8},
                   {325, 4, 1, 64}},
                  Bytes(64, 'x'));
}

Bytes tiffWithChannels() {
    std::vector<Tag> tags = greyTags(4000, 4000, 1, 64);
    tags[6].value = 65535;
    return tiffOf(tags, Bytes(64, 'x'));
}

Bytes tiffInCircles() {
    const std::uint32_t directory = 8 + 16;
    return tiffOf(greyTags(4, 4, 1, 16), Bytes(16, 'x'), directory);
}

Bytes attribute(const Bytes& name, const Bytes& type, const Bytes& value) {
    return name + '\0' + type + '\0' + littleEndian(std::uint32_t(value.size()), 4) + value;
}

Bytes number(std::int32_t value) {
    return littleEndian(std::uint32_t(value), 4);
}

Bytes window(std::int32_t width, std::int32_t height) {
    return number(0) + number(0) + number(width - 1) + number(height - 1);
}

Bytes channelList(int count) {
    Bytes list;
    for (int i = 0; i < count; ++i)
        list += fmt::format("c{}", i) + '\0' + number(2) + Bytes(4, '\0') + number(1) + number(1);
    return list + '\0';
}

struct Exr {
    std::int32_t width = 8, height = 8;
    std::int32_t shownWidth = 8, shownHeight = 8;
    Bytes channels = Bytes("Y\0", 2) + number(2) + Bytes(4, '\0') + number(1) + number(1) + '\0';
    Bytes extra{};

    Bytes header() const {
        const Bytes one = littleEndian(std::bit_cast<std::uint32_t>(1.0f), 4);
        return attribute("channels", "chlist", channels) +
               attribute("compression", "compression", Bytes(1, '\0')) +
               attribute("dataWindow", "box2i", window(width, height)) +
               attribute("displayWindow", "box2i", window(shownWidth, shownHeight)) +
               attribute("lineOrder", "lineOrder", Bytes(1, '\0')) +
               attribute("pixelAspectRatio", "float", one) +
               attribute("screenWindowCenter", "v2f", Bytes(8, '\0')) +
               attribute("screenWindowWidth", "float", one) + extra + '\0';
    }
    /// Without pixels.
    Bytes file(std::uint32_t flags = 0) const {
        return Bytes("\x76\x2f\x31\x01", 4) + littleEndian(2 | flags, 4) + header() + Bytes(256, '\0');
    }
};

Bytes deepExr() {
    Exr exr{100'000, 900, 100'000, 900};
    exr.extra = attribute("type", "string", "deepscanline") + attribute("version", "int", number(1)) +
                attribute("maxSamplesPerPixel", "int", number(0x7fffffff)) +
                attribute("name", "string", "deep") + attribute("chunkCount", "int", number(900));
    return exr.file(0x800);
}

Bytes tiledExr() {
    Exr exr;
    exr.extra = attribute("tiles", "tiledesc", number(0x10000000) + number(0x10000000) + Bytes(1, '\0'));
    return exr.file(0x200);
}

/// A comment of two gigabytes, or so it says.
Bytes exrAttributeOfNothing() {
    Exr exr;
    exr.extra = Bytes("comments\0string\0", 16) + number(0x7d000000) + Bytes(100, 'x');
    return exr.file();
}

/// A small picture in a display window of a hundred megapixels.
Bytes exrInALargeWindow() {
    Exr exr{8, 8, 10'000, 10'000};
    Bytes file = Bytes("\x76\x2f\x31\x01", 4) + littleEndian(2, 4) + exr.header();
    const std::size_t lines = file.size() + 8 * 8;
    for (std::uint32_t y = 0; y < 8; ++y)
        file += littleEndian(std::uint32_t(lines) + y * 40, 4) + Bytes(4, '\0');
    for (std::int32_t y = 0; y < 8; ++y) file += number(y) + number(32) + Bytes(32, '\0');
    return file;
}

Bytes exrOfManyParts() {
    Bytes file = Bytes("\x76\x2f\x31\x01", 4) + littleEndian(2 | 0x1000, 4);
    for (int i = 0; i < 4'000; ++i) {
        Exr exr;
        exr.extra = attribute("type", "string", "scanlineimage") +
                    attribute("chunkCount", "int", number(0x7fffff)) +
                    attribute("name", "string", fmt::format("part{}", i));
        file += exr.header();
    }
    return file + '\0' + Bytes(256, '\0');
}

/// Lossless WebP whose five codes have one symbol each: its pixels take no bits at all.
Bytes webpOfNothing(std::uint32_t width, std::uint32_t height) {
    std::uint64_t bits = (width - 1) | (height - 1) << 14;
    int used = 32 + 3;  // no transform, no colour cache, one set of codes
    for (int code = 0; code < 5; ++code, used += 4) bits |= std::uint64_t(1) << used;
    Bytes data = "\x2f";
    for (int i = 0; i < 8; ++i) data += char(bits >> (8 * i));
    data += '\0';
    return Bytes("RIFF") + littleEndian(std::uint32_t(12 + data.size()), 4) + Bytes("WEBPVP8L") +
           littleEndian(std::uint32_t(data.size()), 4) + data;
}

Bytes hugeJpeg() {
    return Bytes("\xff\xd8\xff\xe0\0\x10JFIF\0\1\1\0\0\1\0\1\0\0", 20) +
           Bytes("\xff\xc0\0\x11\x08\xff\xdc\xff\xdc\3\1\x22\0\2\x11\1\3\x11\1", 19) +
           Bytes("\xff\xda\0\x0c\3\1\0\2\x11\3\x11\0\x3f\0", 14) + Bytes(64, '\x55') + "\xff\xd9";
}

}  // namespace

std::vector<Bomb> imageBombs() {
    return {
        {"png_header", ".png", Opened::Picture,
         [] { return pngHeader(100'000, 100'000) + pngChunk("IDAT", deflated(Bytes(100, 'x'))); }},
        {"png_of_zeros", ".png", Opened::Picture, pngOfZeros},
        {"png_text", ".png", Opened::Picture, pngWithText, true},
        {"png_chunk", ".png", Opened::Picture, pngChunkOfNothing},
        {"tiff_header", ".tif", Opened::Picture,
         [] { return tiffOf(greyTags(0x7fffffff, 0x7fffffff, 1, 64), Bytes(64, 'x')); }},
        {"tiff_of_zeros", ".tif", Opened::Picture, tiffOfZeros},
        {"tiff_tiles", ".tif", Opened::Picture, [] { return tiffWithTiles(1 << 20); }},
        {"tiff_large_tiles", ".tif", Opened::Picture, [] { return tiffWithTiles(1 << 14); }},
        {"tiff_channels", ".tif", Opened::Picture, tiffWithChannels},
        {"tiff_in_circles", ".tif", Opened::Picture, tiffInCircles, true},
        {"exr_header", ".exr", Opened::Picture,
         [] {
             return Exr{0x7ffffff, 0x7ffffff, 8, 8}.file();
         }},
        {"exr_deep", ".exr", Opened::Picture, deepExr},
        {"exr_attribute", ".exr", Opened::Picture, exrAttributeOfNothing},
        {"exr_tiles", ".exr", Opened::Picture, tiledExr},
        {"exr_channels", ".exr", Opened::Picture,
         [] {
             return Exr{4096, 4096, 4096, 4096, channelList(4'000)}.file();
         }},
        {"exr_window", ".exr", Opened::Picture, exrInALargeWindow},
        {"exr_parts", ".exr", Opened::Picture, exrOfManyParts, true},
        {"webp_header", ".webp", Opened::Picture, [] { return webpOfNothing(16'383, 16'383); }},
        {"webp_of_nothing", ".webp", Opened::Picture, [] { return webpOfNothing(10'000, 9'990); }},
        {"jpeg_header", ".jpg", Opened::Picture, hugeJpeg},
    };
}

}  // namespace chiaro::test
