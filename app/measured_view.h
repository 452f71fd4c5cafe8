#pragma once

#include "core/base/task.h"
#include "core/metrics/similarity.h"

#include <memory>
#include <span>
#include <vector>

namespace chiaro::app {

/// A picture of the scene and what is known of it, all of one size.
struct MeasuredView {
    ColorImage picture;  ///< display-referred RGB in [0, 1]
    IdImage objects;     ///< 0 outside, 1.. the object
    ScalarImage light;   ///< L in [0, 1], -1 outside
};

/// A strip in the colours that pictures show, ready to be searched, and who wears it.
struct MeasuredStrip {
    std::shared_ptr<const metrics::NeighbourIndex> index;
    std::vector<bool> wears;  ///< [k] for object k, 1..
};

/// The pixels of a view that were compared with the strips that their objects wear.
struct ViewMatches {
    std::vector<glm::ivec2> pixels;
    std::vector<metrics::PixelMatch> matches;  ///< one a pixel
    metrics::FrameMeasure measure;             ///< over all of them
};

/// Compares pixels that are drawn by chance, all objects alike. The strips are prepared for the params'
/// block. Throws Error when no block lies wholly on an object; Cancelled.
ViewMatches measureView(const MeasuredView& view, std::span<const MeasuredStrip> strips,
                        const metrics::MeasureParams& params, const Task& task = {});

/// Errors over a view; -1, and (-1, -1), where there is none.
struct ViewMaps {
    ScalarImage similarity;
    ScalarImage shadingError;  ///< |shade - L|
    Image<glm::i16vec2> best;  ///< pixel of the strip that resembles it most
    metrics::FrameMeasure measure;
};

/// Compares every pixel, or where `step` > 1 one of step x step and lets it speak for them. Throws what
/// measureView throws.
ViewMaps mapView(const MeasuredView& view, std::span<const MeasuredStrip> strips, int step, int neighbours,
                 const Task& task = {});

}  // namespace chiaro::app
