#include "core/scene/scene.h"

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
    Bounds bounds;
    bool first = true;
    for (const Object& object : scene.objects) {
        if (!object.visible || !object.mesh || object.mesh->triangles.empty()) continue;
        const Bounds local = boundsOf(*object.mesh);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 point((corner & 1) ? local.maximum.x : local.minimum.x,
                                  (corner & 2) ? local.maximum.y : local.minimum.y,
                                  (corner & 4) ? local.maximum.z : local.minimum.z);
            const glm::vec3 world(object.transform * glm::vec4(point, 1));
            bounds.minimum = first ? world : glm::min(bounds.minimum, world);
            bounds.maximum = first ? world : glm::max(bounds.maximum, world);
            first = false;
        }
    }
    return bounds;
}

}  // namespace chiaro::scene
