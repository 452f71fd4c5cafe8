#pragma once

#include "core/base/image.h"

#include <array>

namespace chiaro::sample {

/// A quadrilateral cut out of a scan and straightened (§3).
struct Crop {
    /// Corners in pixels, (0, 0) the outer corner of the first pixel: top-left, top-right, bottom-right,
    /// bottom-left.
    std::array<glm::dvec2, 4> corners;
    int width = 0;   ///< of the result: the mean length of the top and the bottom edge, rounded
    int height = 0;  ///< likewise of the left and the right edge
};

/// The crop whose corners are given in fractions of the scan's width and height. Throws Error when they lie
/// outside the scan or don't go once around a convex quadrilateral.
Crop makeCrop(const std::array<glm::vec2, 4>& fractions, int scanWidth, int scanHeight);

/// The pixels inside the crop: copied where it is a rectangle of whole pixels, else a perspective warp with
/// bicubic interpolation in floating point (no fixed-point steps), clipped to [0, 1].
ColorImage cropped(const ColorImage& scan, const Crop& crop);

}  // namespace chiaro::sample
