#pragma once

#include "core/metrics/frame.h"
#include "core/metrics/neighbours.h"

#include <optional>
#include <span>

namespace chiaro::metrics {

/// What the source says of one pixel of a picture.
struct PixelMatch {
    float distance = 0;    ///< the smallest d to any source pixel
    float shade = 0;       ///< mean of x / (W - 1) over the k nearest source pixels
    glm::i16vec2 best{0};  ///< the nearest source pixel
};

/// One match a pixel, in their order; their blocks lie inside the picture. In parallel, the same on any
/// number of threads. Throws Cancelled.
std::vector<PixelMatch> matchPixels(const NeighbourIndex& source, const ColorImage& picture,
                                    std::span<const glm::ivec2> pixels, int neighbours,
                                    const Task& task = {});

/// Texture similarity (§5.1) and shading error (§5.2) of a picture.
struct FrameMeasure {
    Estimate similarity;                      ///< mean of the smallest d
    std::optional<Estimate> shadingAbsolute;  ///< mean of |shade - L|; absent without light
    std::optional<Estimate> shadingSquared;   ///< mean of (shade - L)^2
};

/// What the matches of a frame's pixels, one a pixel in their order, say together.
FrameMeasure summary(const MeasuredFrame& frame, std::span<const glm::ivec2> pixels,
                     std::span<const PixelMatch> matches);

/// Measures a picture at pixels drawn by chance. `source` was made with the params' block size, else they are
/// refused. Throws Error too when the mask leaves no pixel or sizes differ; Cancelled.
FrameMeasure measureFrame(const NeighbourIndex& source, const MeasuredFrame& frame,
                          const MeasureParams& params, const Task& task = {});

/// Both errors at every pixel; -1, and (-1, -1), where there is none.
struct FrameMaps {
    ScalarImage similarity;    ///< smallest d
    ScalarImage shadingError;  ///< |shade - L|; all -1 without light
    Image<glm::i16vec2> best;  ///< the most similar pixel of the source
    FrameMeasure measure;      ///< over all pixels
};

/// Throws what measureFrame throws.
FrameMaps mapFrame(const NeighbourIndex& source, const MeasuredFrame& frame, int neighbours,
                   const Task& task = {});

}  // namespace chiaro::metrics
