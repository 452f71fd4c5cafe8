#include "core/export/surface_paint.h"

namespace chiaro::exporting {

SurfacePaint::SurfacePaint(const SurfaceLight& light, std::vector<methods::ViewDependentPaint> paints,
                           methods::ViewDependentParams params, Meeting meeting)
    : m_light(light), m_paints(std::move(paints)), m_params(params), m_meeting(meeting) {
    m_params.followCamera = false;
}

glm::vec3 SurfacePaint::color(std::size_t object, std::uint32_t face, glm::vec2 barycentrics) const {
    const methods::ViewDependentPaint& paint = m_paints[object];
    const float l = m_light.at(object, face, barycentrics);
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
