#include "core/export/surface_light.h"

namespace chiaro::exporting {

SurfaceLight::SurfaceLight(const scene::Scene& scene, Bake bake, const Task& task)
    : m_scene(scene), m_bake(bake) {
    for (const scene::Object& object : scene.objects)
        m_normalMatrices.push_back(glm::transpose(glm::inverse(glm::mat3(object.transform))));
    if (bake == Bake::Lit && !scene.occlusion.isOff())
        m_occlusion = std::make_unique<const Occlusion>(scene, task);
}

float SurfaceLight::at(std::size_t object, std::uint32_t face, glm::vec2 barycentrics) const {
    if (m_bake == Bake::Texture) return 0.5f;
    const scene::Mesh& mesh = *m_scene.objects[object].mesh;
    const auto& [a, b, c] = mesh.triangles[face];
    const glm::vec3 weights(1 - barycentrics.x - barycentrics.y, barycentrics);
    const glm::vec3 point =
        mesh.positions[a] * weights.x + mesh.positions[b] * weights.y + mesh.positions[c] * weights.z;
    const glm::vec3 front =
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    glm::vec3 normal =
        mesh.normals[a] * weights.x + mesh.normals[b] * weights.y + mesh.normals[c] * weights.z;
    if (glm::dot(normal, front) < 0) normal = -normal;
    normal = m_normalMatrices[object] * normal;
    const float length = glm::length(normal);
    if (!(length > 0)) return 0.5f;
    normal /= length;
    const glm::vec3 place(m_scene.objects[object].transform * glm::vec4(point, 1));
    if (!m_occlusion) return scene::lightValue(m_scene.lights, place, normal);
    const glm::vec3 faceNormal = m_normalMatrices[object] * front;
    const float area = glm::length(faceNormal);
    const scene::OcclusionCaster::Point seen{place, normal, area > 0 ? faceNormal / area : normal};
    return m_occlusion->caster.light(seen) * m_occlusion->caster.openness(seen);
}

}  // namespace chiaro::exporting
