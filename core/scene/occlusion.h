#pragma once

#include "core/scene/ray_scene.h"

#include <array>

namespace chiaro::scene {

/// Light values where surfaces shade each other. Deterministic; from any thread.
///
/// In the shadow of a light a surface is lit by it as if it were turned away, to a right angle at most: so a
/// shadow ends without a seam where the surface turns away by itself. Ambient occlusion is the share of
/// directions, weighted by the cosine, in which something stands within the radius; what is near counts more.
class OcclusionCaster {
public:
    /// All must stay.
    OcclusionCaster(const RayScene::Impl& rays, const OcclusionParams& params,
                    const std::vector<Light>& lights);

    /// A point of a surface, world space.
    struct Point {
        glm::vec3 position;
        glm::vec3 normal;      ///< unit, interpolated
        glm::vec3 faceNormal;  ///< unit, on the side that is seen
    };
    /// L in [0, 1] with shadows if they are on; without ambient occlusion.
    float light(const Point& point) const;
    /// What ambient occlusion leaves of L, in [1 - ambient, 1].
    float openness(const Point& point) const;

private:
    glm::vec3 origin(const Point& point) const;
    bool isInShadow(const Point& point, const Light& light) const;

    static constexpr int ambientRays = 32;
    const RayScene::Impl& m_rays;
    const OcclusionParams& m_params;
    const std::vector<Light>& m_lights;
    std::array<glm::vec3, ambientRays> m_directions;  ///< around +z, dense where the cosine is large
    std::array<float, ambientRays> m_reaches;         ///< of each ray, scene radii
};

}  // namespace chiaro::scene
