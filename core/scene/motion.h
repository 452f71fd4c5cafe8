#pragma once

#include "core/scene/gbuffer.h"

namespace chiaro::scene {

/// Where a surface point lies in another view.
struct SeenPoint {
    glm::vec2 position{std::numeric_limits<float>::quiet_NaN()};  ///< pixels, x right, y down, a pixel's
                                                                  ///< centre at + 0.5; NaN behind the eye
    float depth = 0;   ///< along that view's direction, world units
    float facing = 0;  ///< n.v: 1 when the surface looks into that view's eye, negative when away from it
    bool exists() const { return depth > 0; }
};

/// For each pixel's surface point of a view where it lies in another view of the same size, exactly, from its
/// depth and both cameras (the objects stand still); outside the objects nothing. Says nothing about whether
/// the other view sees it: something may stand before it. Rows in parallel.
Image<SeenPoint> seenFrom(const GBuffer& gbuffer, const Camera& camera, const Camera& other);

/// The displacement of each pixel's surface point to another view: pixels, x right, y down; 0 outside.
Image<glm::vec2> screenMotion(const GBuffer& gbuffer, const Camera& camera, const Camera& other);

}  // namespace chiaro::scene
