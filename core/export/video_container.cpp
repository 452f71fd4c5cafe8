#include "core/export/video_container.h"

#include <bit>
#include <cstdint>
#include <fstream>
#include <optional>

namespace chiaro::exporting {

namespace {

constexpr std::uint32_t matroskaMagic = 0x1A45DFA3;

std::optional<std::uint64_t> readBigEndian(std::istream& stream, int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) {
        const int byte = stream.get();
        if (byte < 0) return std::nullopt;
        value = value << 8 | std::uint64_t(byte);
    }
    return value;
}

/// The length of the MP4 box here, its head included; 0 for one that goes on to the end of the file.
std::optional<std::uint64_t> boxLength(std::istream& stream) {
    const auto length = readBigEndian(stream, 4), type = readBigEndian(stream, 4);
    if (!length || !type) return std::nullopt;
    const auto whole = *length == 1 ? readBigEndian(stream, 8) : length;
    const std::uint64_t head = *length == 1 ? 16 : 8;
    return whole && (*whole >= head || *whole == 0) ? whole : std::nullopt;
}

/// A number whose first byte's leading zeros tell how many bytes follow; its mark stays in an identifier.
std::optional<std::uint64_t> readEbml(std::istream& stream, bool keepsMark, int& bytes) {
    const int first = stream.peek();
    if (first <= 0) return std::nullopt;
    bytes = std::countl_zero(std::uint8_t(first)) + 1;
    const auto value = readBigEndian(stream, bytes);
    const std::uint64_t mark = std::uint64_t(1) << (7 * bytes);
    if (!value || keepsMark) return value;
    const std::uint64_t number = *value & (mark - 1);
    return number == mark - 1 ? std::nullopt : std::optional(number);  // all ones: not known yet
}

/// The length of the Matroska element here, its head included.
std::optional<std::uint64_t> elementLength(std::istream& stream) {
    int identifierBytes = 0, sizeBytes = 0;
    if (!readEbml(stream, true, identifierBytes)) return std::nullopt;
    const auto size = readEbml(stream, false, sizeBytes);
    return size ? std::optional(*size + std::uint64_t(identifierBytes + sizeBytes)) : std::nullopt;
}

}  // namespace

bool isWholeContainer(const std::filesystem::path& path) {
    std::error_code error;
    const std::uint64_t end = std::filesystem::file_size(path, error);
    std::ifstream stream(path, std::ios::binary);
    const auto magic = readBigEndian(stream, 4);
    if (error || !magic) return false;
    const auto length = *magic == matroskaMagic ? elementLength : boxLength;
    std::uint64_t position = 0;
    while (position < end) {
        stream.seekg(std::streamoff(position));
        const auto part = length(stream);
        if (!part || *part > end - position) return false;
        if (*part == 0) return true;
        position += *part;
    }
    return true;
}

}  // namespace chiaro::exporting
