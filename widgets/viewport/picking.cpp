#include "widgets/viewport/picking.h"

#include "widgets/viewport/view_state.h"

#include <algorithm>

namespace chiaro::widgets {

namespace {

struct Ray {
    glm::vec3 origin;
    glm::vec3 direction;  ///< any length; distances are in units of it
};

/// Where the ray meets the triangle (Moeller and Trumbore 1997); infinity where it does not.
float distanceTo(const Ray& ray, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    constexpr float missed = std::numeric_limits<float>::infinity();
    const glm::vec3 ab = b - a;
    const glm::vec3 ac = c - a;
    const glm::vec3 p = glm::cross(ray.direction, ac);
    const float determinant = glm::dot(ab, p);
    if (determinant == 0) return missed;
    const glm::vec3 fromA = ray.origin - a;
    const float u = glm::dot(fromA, p) / determinant;
    if (!(u >= 0 && u <= 1)) return missed;
    const glm::vec3 q = glm::cross(fromA, ab);
    const float v = glm::dot(ray.direction, q) / determinant;
    if (!(v >= 0 && u + v <= 1)) return missed;
    const float distance = glm::dot(ac, q) / determinant;
    return distance > 0 ? distance : missed;
}

float distanceTo(const Ray& ray, const scene::Mesh& mesh) {
    float nearest = std::numeric_limits<float>::infinity();
    for (const scene::Triangle& triangle : mesh.triangles)
        nearest = std::min(nearest, distanceTo(ray, mesh.positions[triangle[0]], mesh.positions[triangle[1]],
                                               mesh.positions[triangle[2]]));
    return nearest;
}

}  // namespace

std::optional<std::size_t> objectAt(const scene::Scene& scene, const scene::Camera& camera, QPointF point,
                                    QSizeF viewport) {
    const glm::vec2 extent = camera.halfExtent(int(viewport.width()), int(viewport.height()));
    const float x = (2 * float(point.x() / viewport.width()) - 1) * extent.x;
    const float y = (1 - 2 * float(point.y() / viewport.height())) * extent.y;
    const Ray world{camera.position(), camera.basis() * glm::vec3(x, y, -1)};
    std::optional<std::size_t> picked;
    float nearest = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object& object = scene.objects[i];
        if (!isDrawn(object)) continue;
        const glm::mat4 worldToObject = glm::inverse(object.transform);
        const Ray local{glm::vec3(worldToObject * glm::vec4(world.origin, 1)),
                        glm::mat3(worldToObject) * world.direction};
        const float distance = distanceTo(local, *object.mesh);
        if (distance >= nearest) continue;
        nearest = distance;
        picked = i;
    }
    return picked;
}

}  // namespace chiaro::widgets
