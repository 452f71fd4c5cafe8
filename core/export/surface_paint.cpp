#include "core/export/surface_paint.h"

namespace chiaro::exporting {

SurfacePaint::SurfacePaint(const scene::Scene& scene, std::vector<methods::ViewDependentPaint> paints,
                           methods::ViewDependentParams params, Meeting meeting, Bake bake)
    : m_scene(scene), m_paints(std::move(paints)), m_params(params), m_meeting(meeting), m_bake(bake) {
    m_params.followCamera = false;
    for (const scene::Object& object : scene.objects)
        m_normalMatrices.push_back(glm::transpose(glm::inverse(glm::mat3(object.transform))));
}

float SurfacePaint::light(std::size_t object, std::uint32_t face, glm::vec2 barycentrics) const {
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
    const glm::vec3 place(m_scene.objects[object].transform * glm::vec4(point, 1));
    return scene::lightValue(m_scene.lights, place, normal / length);
}

glm::vec3 SurfacePaint::color(std::size_t object, std::uint32_t face, glm::vec2 barycentrics) const {
    const methods::ViewDependentPaint& paint = m_paints[object];
    const float l = light(object, face, barycentrics);
    const bool isPicture = m_meeting == Meeting::Pictures && paint.object;
    const glm::vec3 texture = isPicture
                                  ? ofPictures(*paint.object, face, barycentrics)
                                  : methods::viewDependentTexture(paint, m_params, face, barycentrics, l);
    return glm::clamp(gradient::lookUp(*paint.gradient, double(l)) + texture, 0.0f, 1.0f);
}

glm::vec3 SurfacePaint::ofPictures(const methods::PaintedObject& painted, std::uint32_t face,
                                   glm::vec2 barycentrics) const {
    const glm::vec3 weights(1 - barycentrics.x - barycentrics.y, barycentrics);
    glm::vec3 sum(0);
    float squares = 0;
    for (const methods::ViewWeights::FaceView& view : painted.weights->of(face)) {
        const methods::ViewTexture& texture = painted.textures.views[view.group];
        if (texture.levels.empty()) continue;
        const auto& [a, b, c] = view.corners;
        const float linear = a.weight * weights.x + b.weight * weights.y + c.weight * weights.z;
        const float weight = linear * linear * linear * linear;
        sum +=
            weight * texture.at(0, a.position * weights.x + b.position * weights.y + c.position * weights.z);
        squares += weight * weight;
    }
    return squares > 0 ? sum / std::sqrt(squares) : sum;
}

}  // namespace chiaro::exporting
