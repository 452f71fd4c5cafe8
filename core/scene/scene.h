#pragma once

#include "core/scene/camera.h"
#include "core/scene/mesh.h"
#include "core/scene/occlusion_params.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace chiaro::scene {

/// A light: far away in a direction, or at a point (which shines the same at any distance).
struct Light {
    enum class Kind { Directional, Point };
    Kind kind = Kind::Directional;
    glm::vec3 vector{-0.5f, 0.7f, 0.6f};  ///< world space; directional: from the surface towards the light,
                                          ///< any length but zero; point: where it stands
    float intensity = 1;                  ///< 0..4
    bool wrap = true;                     ///< L = (1 + n.l)/2 (§4) instead of max(n.l, 0)
    bool visible = true;                  ///< one that is not shines no light
    std::string name{};                   ///< for the artist; may be empty
    friend bool operator==(const Light&, const Light&) = default;

    /// Unit vector from a surface towards the light; zero where a point light stands on the surface.
    glm::vec3 direction(glm::vec3 position) const;
    /// How far away the light is; infinity for a directional one.
    float distance(glm::vec3 position) const;
    /// What it gives to L where the normal and the direction towards it have this cosine.
    float shine(float cosine) const {
        return intensity * (wrap ? 0.5f + 0.5f * cosine : std::max(cosine, 0.0f));
    }
};

/// A mesh at its place. Object ids are 1 + the index in Scene::objects.
struct Object {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
    glm::mat4 transform{1};  ///< object to world, invertible
    int sample = 0;          ///< index of the paint sample it wears
    bool visible = true;
};

/// Everything that light and eye meet. A plain value; meshes are shared, immutable snapshots.
struct Scene {
    std::vector<Object> objects;  ///< at most 65535
    std::vector<Light> lights{Light{}};
    OcclusionParams occlusion = {};
};

/// Light value L in [0, 1] of a surface with this unit normal at this world position (§4), where nothing
/// keeps light away.
float lightValue(const std::vector<Light>& lights, glm::vec3 position, glm::vec3 normal);

/// World-space bounds of the visible objects.
Bounds boundsOf(const Scene& scene);

}  // namespace chiaro::scene
