#pragma once

#include "core/scene/camera.h"
#include "core/scene/mesh.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

namespace chiaro::scene {

/// A light. Only directional ones are made today; a point light adds a kind and reads `vector` as a position.
struct Light {
    enum class Kind { Directional };
    Kind kind = Kind::Directional;
    glm::vec3 vector{-0.5f, 0.7f,
                     0.6f};  ///< world space, from the surface towards the light; any length but zero
    float intensity = 1;     ///< 0..4
    bool wrap = true;        ///< L = (1 + n.l)/2 (§4) instead of max(n.l, 0)
    friend bool operator==(const Light&, const Light&) = default;
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
};

/// Light value L in [0, 1] of a surface with this unit normal at this world position (§4).
float lightValue(const std::vector<Light>& lights, glm::vec3 position, glm::vec3 normal);

/// World-space bounds of the visible objects.
Bounds boundsOf(const Scene& scene);

}  // namespace chiaro::scene
