#pragma once

#include "core/base/task.h"
#include "core/metrics/descriptor.h"
#include "core/metrics/frame.h"
#include "core/scene/motion.h"

namespace chiaro::metrics {

/// How much the texture changes from one frame to the next (§5.3), as mean d over pixels drawn by chance.
/// Frames are of one size; `bins` are the source's. Both throw Error when no pixel can be measured or when
/// sizes differ.

/// 1 at the pixels of the first frame whose blocks lie on one and the same object in both frames.
Image<std::uint8_t> comparableInImage(const MeasuredFrame& first, const MeasuredFrame& second, int block);

/// Image space: the same pixel in both frames. Both blocks lie on one and the same object.
Estimate imageCoherence(const Bins& bins, const MeasuredFrame& first, const MeasuredFrame& second,
                        const MeasureParams& params);

/// Where surface points go from one frame to the next.
struct SurfaceMotion {
    /// Pixels, x right, y down. The point at the centre of pixel p lands in the pixel in which the centre
    /// plus the displacement lies. NaN: nowhere.
    const Image<glm::vec2>* displacement = nullptr;
    /// 0 where the point isn't seen in the next frame; without it every point whose landing pixel is of the
    /// same object counts as seen.
    const Image<std::uint8_t>* seen = nullptr;
};

/// 1 at the pixels of the first frame whose surface points are seen in the second, both blocks on their
/// object.
Image<std::uint8_t> comparableOnObject(const MeasuredFrame& first, const MeasuredFrame& second,
                                       const SurfaceMotion& motion, int block);

/// Object space: the two pixels where the same surface point lands. Both blocks lie on its object.
Estimate objectCoherence(const Bins& bins, const MeasuredFrame& first, const MeasuredFrame& second,
                         const SurfaceMotion& motion, const MeasureParams& params);

/// 1 at the pixels of a view whose surface points another view of the same size sees too: where they land,
/// the other view shows the same object at the same depth, within 1% of it and what the surface's slope
/// explains over a pixel.
Image<std::uint8_t> seenInBoth(const scene::GBuffer& first, const Image<scene::SeenPoint>& landings,
                               const scene::GBuffer& second);

}  // namespace chiaro::metrics
