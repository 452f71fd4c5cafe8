#pragma once

#include "core/scene/gbuffer.h"

#include <vector>

namespace chiaro::methods {

/// What a picture shows of one object (§4.1: the guide), cut to its bounding box.
struct ObjectGuide {
    glm::ivec2 origin{0};  ///< of the box's top left pixel in the picture
    Image<std::uint8_t>
        covered;        ///< not 0 where the pixel's centre or one of its finer samples is the object's
    ScalarImage light;  ///< L in [0, 1] there: at the centre, else the mean of the finer samples
    bool empty() const { return covered.empty(); }
};

/// The guides of objects 1..objects of a view, [k - 1] of object k; empty for those that it doesn't show.
/// Throws Error when it shows another object.
std::vector<ObjectGuide> objectGuides(const scene::GBuffer& gbuffer, std::size_t objects);

/// Makes a guide cover what another one of the same object covers too, with the light that it has there;
/// where both cover, the guide keeps its own.
void extend(ObjectGuide& guide, const ObjectGuide& other);

}  // namespace chiaro::methods
