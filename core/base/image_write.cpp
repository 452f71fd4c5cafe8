#include "core/base/atomic_file.h"
#include "core/base/codec/codec.h"
#include "core/base/error.h"
#include "core/base/image_format.h"
#include "core/base/image_io.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace chiaro {

namespace fs = std::filesystem;

namespace {

template <class Value>
void encode(const fs::path& path, ImageFormat format, int width, int height, int channels,
            const std::vector<Value>& values, const ImageMetadata& metadata) {
    using Values = EncodeRequest::Values;
    constexpr Values type = sizeof(Value) == 1   ? Values::Bits8
                            : sizeof(Value) == 2 ? Values::Bits16
                                                 : Values::Float;
    if (values.empty()) throw Error(path.string(), "the picture has no pixels", "give it a size");
    writeFileAtomically(
        path, imageCodec().encode({path, format, width, height, channels, type, values.data(), metadata}));
}

/// 0..1 to 0..255 or 0..65535, halves up; NaN becomes 0.
template <class Value>
Value quantized(float value) {
    constexpr float highest = float(std::numeric_limits<Value>::max());
    if (!(value > 0)) return 0;
    return Value(std::floor(double(std::min(value, 1.0f)) * double(highest) + 0.5));
}

template <class Value>
std::vector<Value> quantized(std::span<const float> values) {
    std::vector<Value> result(values.size());
    std::transform(values.begin(), values.end(), result.begin(), [](float v) { return quantized<Value>(v); });
    return result;
}

void writeChannels(const fs::path& path, int width, int height, int channels, std::span<const float> values,
                   const ImageMetadata& metadata, PixelDepth depth) {
    const ImageFormat format = writableFormat(path);
    if (format == ImageFormat::OpenExr)
        encode(path, format, width, height, channels, std::vector<float>(values.begin(), values.end()),
               metadata);
    else if (depth == PixelDepth::Bits16 && format != ImageFormat::Jpeg)
        encode(path, format, width, height, channels, quantized<std::uint16_t>(values), metadata);
    else
        encode(path, format, width, height, channels, quantized<std::uint8_t>(values), metadata);
}

template <class Pixel>
std::span<const float> floats(const Image<Pixel>& image) {
    static_assert(sizeof(Pixel) % sizeof(float) == 0);
    return {reinterpret_cast<const float*>(image.pixels().data()),
            image.pixelCount() * (sizeof(Pixel) / sizeof(float))};
}

ColorImage onWhite(const ColorAlphaImage& image) {
    ColorImage opaque(image.width(), image.height());
    std::transform(image.pixels().begin(), image.pixels().end(), opaque.pixels().begin(),
                   [](const glm::vec4& p) { return glm::vec3(p) * p.a + (1 - p.a); });
    return opaque;
}

}  // namespace

void writeImage(const fs::path& path, const ColorImage& image, const ImageMetadata& metadata,
                PixelDepth depth) {
    writeChannels(path, image.width(), image.height(), 3, floats(image), metadata, depth);
}

void writeImage(const fs::path& path, const ColorAlphaImage& image, const ImageMetadata& metadata,
                PixelDepth depth) {
    const ImageFormat format = writableFormat(path);
    if (format == ImageFormat::Jpeg) return writeImage(path, onWhite(image), metadata, depth);
    if (format != ImageFormat::OpenExr)
        return writeChannels(path, image.width(), image.height(), 4, floats(image), metadata, depth);
    ColorAlphaImage premultiplied = image;
    for (glm::vec4& pixel : premultiplied.pixels()) pixel = {glm::vec3(pixel) * pixel.a, pixel.a};
    writeChannels(path, image.width(), image.height(), 4, floats(premultiplied), metadata, depth);
}

void writeImage(const fs::path& path, const ScalarImage& image, const ImageMetadata& metadata,
                PixelDepth depth) {
    writeChannels(path, image.width(), image.height(), 1, floats(image), metadata, depth);
}

void writeImage(const fs::path& path, const Image<glm::vec2>& image, const ImageMetadata& metadata) {
    const ImageFormat format = writableFormat(path);
    if (format != ImageFormat::OpenExr)
        throw Error(path.string(), fmt::format("{} can't hold two values a pixel", displayName(format)),
                    "use .exr");
    writeChannels(path, image.width(), image.height(), 2, floats(image), metadata, {});
}

void writeImage(const fs::path& path, const IdImage& image, const ImageMetadata& metadata) {
    const ImageFormat format = writableFormat(path);
    if (format != ImageFormat::Png && format != ImageFormat::Tiff)
        throw Error(path.string(), fmt::format("{} can't hold object numbers exactly", displayName(format)),
                    "use .png or .tif");
    const auto ids = image.pixels();
    if (std::all_of(ids.begin(), ids.end(), [](std::uint16_t id) { return id < 256; }))
        encode(path, format, image.width(), image.height(), 1,
               std::vector<std::uint8_t>(ids.begin(), ids.end()), metadata);
    else
        encode(path, format, image.width(), image.height(), 1,
               std::vector<std::uint16_t>(ids.begin(), ids.end()), metadata);
}

}  // namespace chiaro
