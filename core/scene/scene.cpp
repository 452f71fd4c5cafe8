#include "core/scene/scene.h"

#include <algorithm>
#include <limits>

namespace chiaro::scene {

glm::vec3 Light::direction(glm::vec3 position) const {
    if (kind == Kind::Directional) return glm::normalize(vector);
    const glm::vec3 way = vector - position;
    const float length = glm::length(way);
    return length > 0 ? way / length : glm::vec3(0);
}

float Light::distance(glm::vec3 position) const {
    return kind == Kind::Directional ? std::numeric_limits<float>::infinity()
                                     : glm::distance(vector, position);
}

float lightValue(const std::vector<Light>& lights, glm::vec3 position, glm::vec3 normal) {
    float sum = 0;
    for (const Light& light : lights)
        if (light.visible) sum += light.shine(glm::dot(normal, light.direction(position)));
    return std::clamp(sum, 0.0f, 1.0f);
}

Bounds boundsOf(const Scene& scene) {
    BoundsBuilder builder;
    for (const Object& object : scene.objects)
        if (object.visible && object.mesh) builder.addMesh(*object.mesh, object.transform);
    return builder.bounds();
}

}  // namespace chiaro::scene
