#include "core/scene/scene.h"

#include <algorithm>

namespace chiaro::scene {

float lightValue(const std::vector<Light>& lights, glm::vec3 /*position*/, glm::vec3 normal) {
    float sum = 0;
    for (const Light& light : lights) {
        const float cosine = glm::dot(normal, glm::normalize(light.vector));
        sum += light.intensity * (light.wrap ? 0.5f + 0.5f * cosine : std::max(cosine, 0.0f));
    }
    return std::clamp(sum, 0.0f, 1.0f);
}

Bounds boundsOf(const Scene& scene) {
    BoundsBuilder builder;
    for (const Object& object : scene.objects)
        if (object.visible && object.mesh) builder.addMesh(*object.mesh, object.transform);
    return builder.bounds();
}

}  // namespace chiaro::scene
