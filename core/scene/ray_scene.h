#pragma once

#include "core/scene/gbuffer.h"

#include <embree3/rtcore.h>

#include <span>

namespace chiaro::scene {

/// One object as the rays meet it.
struct RayObject {
    std::shared_ptr<const Mesh> mesh;  ///< null for an object that is not visible
    std::vector<glm::vec3> normals;    ///< world space, unit
};

struct RayScene::Impl {
    Impl() = default;
    Impl(const Scene& scene, const Task& task);
    ~Impl();
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<RayObject> objects;
    // Embree works in single precision with tolerances around 1: rays and vertices are given to it with the
    // scene's centre in the origin and its radius as the unit.
    glm::dvec3 center{0};
    double unit = 1;
};

constexpr int packetSize = 16;

/// What up to 16 rays from one eye met; object 0 is nothing.
struct Hit {
    std::uint16_t object = 0;
    std::uint32_t face = 0xFFFFFFFF;
    glm::vec2 barycentrics{0};
    float depth = std::numeric_limits<float>::infinity();  ///< world units, along the view direction
    glm::vec3 faceNormal{0};                               ///< world space, unit, towards the eye
};

/// A camera ready to cast through points of its picture.
class RayCaster {
public:
    RayCaster(const RayScene::Impl& rays, const Camera& camera, int width, int height);

    /// Casts through picture positions (pixels, x right, y down), at most 16. At equal depth the smaller
    /// object and face win, so that coincident faces do not depend on how the acceleration structure was
    /// built.
    void cast(std::span<const glm::vec2> positions, std::span<Hit> hits) const;

    /// World-space direction through a picture position, of length 1 along the view direction.
    glm::vec3 direction(glm::vec2 position) const;
    glm::vec3 eye() const { return m_eye; }
    glm::vec3 pointAt(glm::vec2 position, float depth) const { return m_eye + direction(position) * depth; }
    /// The interpolated normal of a hit, world space, unit, towards the eye.
    glm::vec3 normal(const Hit& hit, glm::vec2 position) const;
    /// Width of a pixel on a surface at distance 1 that faces the eye.
    float pixelSize() const { return m_step.x; }

private:
    const RayScene::Impl& m_rays;
    glm::vec3 m_eye;
    glm::vec3 m_localEye;
    glm::mat3 m_basis;
    glm::vec2 m_corner;  ///< of the picture, at distance 1: left and top
    glm::vec2 m_step;    ///< of a pixel, at distance 1
    float m_near;
    float m_far;
};

}  // namespace chiaro::scene
