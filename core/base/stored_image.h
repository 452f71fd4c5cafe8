#pragma once

#include "core/base/image_io.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>

namespace chiaro {

/// A picture as its decoder leaves it, before its values become floats: plain, so that it can come from
/// another process, which is not to be trusted.
struct StoredImage {
    enum class Values : std::uint8_t { Bits8, Bits16, Float };
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::int32_t stride = 0;                 ///< values a pixel
    std::int32_t channelCount = 0;           ///< 1..4
    std::array<std::int32_t, 4> channels{};  ///< which of a pixel's values, in the order of DecodedImage
    Values type = Values::Bits8;
    bool isPremultiplied = false;
    bool isLinear = false;
    std::int32_t orientation = 1;  ///< EXIF's
    std::int32_t x = 0;            ///< where the first pixel lies in the canvas
    std::int32_t y = 0;
    std::int32_t canvasWidth = 0;  ///< of OpenEXR's display window, else the picture's own
    std::int32_t canvasHeight = 0;

    std::size_t byteCount() const;  ///< of the values; meaningful once checked
};

/// Gives memory for the values before they are decoded.
using AllocateValues = std::function<void*(std::size_t bytes)>;

/// Throws Error naming the file when the picture is empty or larger than the limits allow.
void checkImageSize(const std::filesystem::path& path, int width, int height, const ImageLimits& limits);

/// The picture with its values as floats, upright on its canvas. Throws Error naming the file when values
/// aren't finite where they must be, the limits are exceeded, or the picture's numbers contradict each other.
DecodedImage decodedFrom(const StoredImage& stored, std::span<const std::byte> values,
                         const std::filesystem::path& path, const ImageLimits& limits);

}  // namespace chiaro
