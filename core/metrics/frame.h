#pragma once

#include "core/base/image.h"
#include "core/base/parameters.h"

#include <vector>

namespace chiaro::metrics {

/// How a picture is measured (§5).
struct MeasureParams {
    int block = 8;           ///< side of the compared blocks, 4..16 px
    int neighbours = 3;      ///< source pixels whose shades are averaged for the shading error, 1..16
    int pixels = 100;        ///< that are drawn by chance; 0 is every one
    std::uint64_t seed = 1;  ///< of the draw
    static const ParameterTable<MeasureParams>& table();
    friend bool operator==(const MeasureParams&, const MeasureParams&) = default;
};

/// A picture to measure. What pointers lead to is as large as the picture.
struct MeasuredFrame {
    const ColorImage* picture = nullptr;  ///< display-referred RGB in [0, 1]
    const IdImage* objects = nullptr;     ///< 0 outside, 1.. the object; without it all is one object
    const ScalarImage* light = nullptr;  ///< true L in [0, 1], outside -1 or NaN; without it no shading error
    int object = 0;                      ///< measure this object alone; 0: all
};

/// A mean over pixels and how sure it is.
struct Estimate {
    double mean = 0;
    double standardError = 0;  ///< sample deviation / sqrt(count); 0 for one value
    std::size_t count = 0;
};
Estimate estimate(const std::vector<double>& values);

/// Where blocks of `block` x `block` pixels lie inside the picture and wholly on one object (§5.1): 1 at the
/// pixels that such a block surrounds, 0 elsewhere. Throws Error when the parts of the frame differ in size
/// or the picture is smaller than a block.
Image<std::uint8_t> measurable(const MeasuredFrame& frame, int block);

/// Whether a mask leaves anything to measure: a pixel that isn't 0.
bool anyPixel(const Image<std::uint8_t>& mask);

/// `count` of the pixels that aren't 0, each at most once, drawn by chance; all of them in raster order when
/// `count` is 0 or not less than there are. Throws Error, saying `what` leaves no pixel, when there are none.
std::vector<glm::ivec2> drawPixels(const Image<std::uint8_t>& from, int count, std::uint64_t seed,
                                   const char* what);

}  // namespace chiaro::metrics
