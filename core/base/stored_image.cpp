#include "core/base/stored_image.h"

#include "core/base/helper/file_request.h"
#include "core/base/image_layout.h"

#include <spdlog/fmt/fmt.h>

#include <cstring>

namespace chiaro {

namespace fs = std::filesystem;

namespace {

float unitValue(std::uint8_t value) {
    return float(value) / 255.0f;
}
float unitValue(std::uint16_t value) {
    return float(value) / 65535.0f;
}
float unitValue(float value) {
    return value;
}

template <class Value>
float valueAt(const std::byte* values, std::size_t index) {
    Value value;
    std::memcpy(&value, values + index * sizeof value, sizeof value);
    return unitValue(value);
}

template <class Value>
void convert(const StoredImage& stored, const std::byte* from, std::vector<float>& values) {
    const auto count = std::size_t(stored.channelCount), stride = std::size_t(stored.stride);
    bool isInOrder = count == stride;
    for (std::size_t k = 0; k < count; ++k) isInOrder = isInOrder && stored.channels[k] == int(k);
    if (isInOrder) {  // as in almost every file; the compiler makes vectors of it
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = valueAt<Value>(from, i);
        return;
    }
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = valueAt<Value>(from, i / count * stride + std::size_t(stored.channels[i % count]));
}

std::size_t valueSize(StoredImage::Values type) {
    switch (type) {
        case StoredImage::Values::Bits8:
            return 1;
        case StoredImage::Values::Bits16:
            return 2;
        case StoredImage::Values::Float:
            return 4;
    }
    return 0;
}

/// Whether the numbers describe the values that are there.
bool agrees(const StoredImage& stored, std::size_t bytes) {
    if (stored.type > StoredImage::Values::Float || stored.stride < 1 || stored.stride > 65536) return false;
    if (stored.channelCount < 1 || stored.channelCount > 4) return false;
    for (int k = 0; k < stored.channelCount; ++k)
        if (stored.channels[std::size_t(k)] < 0 || stored.channels[std::size_t(k)] >= stored.stride)
            return false;
    return stored.byteCount() == bytes;
}

}  // namespace

std::size_t StoredImage::byteCount() const {
    return std::size_t(width) * std::size_t(height) * std::size_t(stride) * valueSize(type);
}

void checkImageSize(const fs::path& path, int width, int height, const ImageLimits& limits) {
    const auto pixels = std::uint64_t(std::max(width, 0)) * std::uint64_t(std::max(height, 0));
    if (pixels > 0 && pixels <= limits.maximumPixels && width <= limits.maximumSide &&
        height <= limits.maximumSide)
        return;
    throw Error(path.string(), fmt::format("is {} x {} pixels", width, height),
                fmt::format("pictures may be up to {} pixels wide or high and {} megapixels",
                            limits.maximumSide, limits.maximumPixels / 1'000'000));
}

DecodedImage decodedFrom(const StoredImage& stored, std::span<const std::byte> values, const fs::path& path,
                         const ImageLimits& limits) {
    checkImageSize(path, stored.width, stored.height, limits);
    checkImageSize(path, stored.canvasWidth, stored.canvasHeight, limits);
    if (!agrees(stored, values.size()) || (limits.asVectors && stored.channelCount != 2))
        throw helper::nonsense(path);
    DecodedImage image{stored.width, stored.height, stored.channelCount, stored.isLinear, {}, 0};
    image.values.resize(std::size_t(stored.width) * std::size_t(stored.height) *
                        std::size_t(stored.channelCount));
    switch (stored.type) {
        case StoredImage::Values::Bits8:
            image.bits = 8;
            convert<std::uint8_t>(stored, values.data(), image.values);
            break;
        case StoredImage::Values::Bits16:
            image.bits = 16;
            convert<std::uint16_t>(stored, values.data(), image.values);
            break;
        case StoredImage::Values::Float:
            convert<float>(stored, values.data(), image.values);
            break;
    }
    if (stored.isPremultiplied) unpremultiply(image);
    if (stored.type == StoredImage::Values::Float && !limits.mayBeNotFinite && !allFinite(image.values))
        throw Error(path.string(), "has pixels that are not finite numbers",
                    "replace the NaN and infinite pixels and save it again");
    if (stored.x != 0 || stored.y != 0 || stored.canvasWidth != stored.width ||
        stored.canvasHeight != stored.height)
        image = placed(image, stored.x, stored.y, stored.canvasWidth, stored.canvasHeight);
    return upright(std::move(image), stored.orientation);
}

}  // namespace chiaro
