#pragma once

#include "core/base/image.h"
#include "core/base/parameters.h"

#include <array>
#include <filesystem>

namespace chiaro::sample {

/// How a scan becomes a strip (§3), in this order: crop, turn, mirror, scale.
struct StripParams {
    /// The crop quadrilateral's corners on the scan, top-left, top-right, bottom-right, bottom-left,
    /// in fractions of its width and height; (0,0) is the outer corner of the first pixel, (1,1) of the last.
    std::array<glm::vec2, 4> crop{glm::vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    int quarterTurns = 0;  ///< clockwise, 0..3
    bool mirror = false;   ///< left to right, for scans with light on the left
    double scale = 1;  ///< of the strip's size, 0.05..8; sets stroke density, since strokes on screen are as
                       ///< large as in the strip

    static const ParameterTable<StripParams>& table();  ///< all but the crop
    friend bool operator==(const StripParams&, const StripParams&) = default;
};

/// Reads a scan: RGB, display-referred in [0, 1]. Linear files are sRGB-encoded and clipped, grey becomes
/// RGB, alpha is composited over white paper. Throws Error naming the file.
ColorImage readScan(const std::filesystem::path& path);

/// The strip of a scan (§3): dark at the left, light at the right. With default params the scan's own pixels,
/// bit for bit. Throws Error when the result is not 64..8192 wide and 16..4096 high, or when the crop is not
/// convex or lies outside.
ColorImage makeStrip(const ColorImage& scan, const StripParams& params = {});

/// The strip of a scan file: readScan and makeStrip. Throws Error naming the file, whatever is wrong with it.
ColorImage readStrip(const std::filesystem::path& path, const StripParams& params = {});

}  // namespace chiaro::sample
