#pragma once

#include "core/scene/mesh.h"

#include <glm/glm.hpp>

namespace chiaro::scene {

/// A perspective camera that orbits a target; +Y is up. Angles in degrees. A plain value; every function is
/// pure.
struct Camera {
    float azimuth = 30;    ///< around +Y, 0 looks from +Z, 90 from +X
    float elevation = 15;  ///< above the horizon, -90..90
    float distance = 1;    ///< in units of the distance from which the target sphere just fills the picture's
                           ///< smaller side, 0.01..100
    glm::vec3 target{0};   ///< world space, the centre of the target sphere
    float radius = 1;      ///< of the target sphere, world units, > 0
    float fieldOfView = 30;  ///< across the smaller side of the picture, 1..120
    friend bool operator==(const Camera&, const Camera&) = default;

    /// The eye, world space.
    glm::vec3 position() const;
    /// Columns: right, up, and from the target towards the eye; world space, orthonormal, also straight above
    /// and straight below.
    glm::mat3 basis() const;
    /// World to view space: x right, y up, the camera looks along -z.
    glm::mat4 view() const;
    /// OpenGL clip space (z in [-w, w]), y up.
    glm::mat4 projection(int width, int height) const;
    /// Half the picture's width and height at distance 1 in front of the eye.
    glm::vec2 halfExtent(int width, int height) const;
    /// Distance between eye and target, world units.
    float eyeDistance() const;
    /// Clipping distances along the view direction, world units; the G-buffer keeps to them too.
    float nearPlane() const;
    float farPlane() const;
    /// Aims at the bounds' centre and fits their sphere; angles and distance factor stay.
    Camera framed(const Bounds& bounds) const;
};

}  // namespace chiaro::scene
