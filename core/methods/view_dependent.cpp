#include "core/methods/view_dependent.h"

#include <algorithm>

namespace chiaro::methods {

namespace {

/// How fast a view's weight falls as the camera turns away from it.
constexpr float cameraSharpness = 6;

glm::vec3 interpolatedLevels(const ViewTexture& texture, glm::vec2 position, float light) {
    const int last = int(texture.levels.size()) - 1;
    const float slice = glm::clamp(light * float(last + 1) - 0.5f, 0.0f, float(last));
    const int lower = std::min(int(slice), last);
    const float t = slice - float(lower);
    const glm::vec3 texel = texture.at(std::size_t(lower), position);
    return t == 0 ? texel : glm::mix(texel, texture.at(std::size_t(lower) + 1, position), t);
}

/// Its share of the weight when views near the camera's count more.
float cameraWeight(const ViewDependentPaint& paint, const views::View& view, glm::vec3 point) {
    const glm::vec3 towardsCamera = glm::normalize(paint.eye - point);
    const float cosine = glm::dot(towardsCamera, glm::vec3(glm::normalize(view.direction)));
    return std::exp(cameraSharpness * (cosine - 1));
}

glm::vec3 pointOn(const views::Surface& surface, std::uint32_t face, glm::vec3 weights) {
    return glm::vec3(surface.corner(face, 0)) * weights.x + glm::vec3(surface.corner(face, 1)) * weights.y +
           glm::vec3(surface.corner(face, 2)) * weights.z;
}

}  // namespace

const ParameterTable<ViewDependentParams>& ViewDependentParams::table() {
    static const auto table =
        ParameterTable<ViewDependentParams>()
            .add(&ViewDependentParams::propagate,
                 ParameterSpec::boolean(
                     "propagate", "Propagate",
                     "Let a view go on from what other views painted on the faces that they "
                     "share, so that strokes agree where views meet."))
            .add(&ViewDependentParams::followCamera,
                 ParameterSpec::boolean("follow-camera", "Follow camera",
                                        "Let the views nearest to the camera count more: crisper where views "
                                        "differ, but strokes change as the camera moves."))
            .add(&ViewDependentParams::blend,
                 ParameterSpec::choice("view-blend", "Blend", {"linear", "preserving"},
                                       "How the views' textures meet: linear, or with the contrast kept, "
                                       "which is for views that don't agree (without Propagate)."));
    return table;
}

glm::vec3 viewDependentTexture(const ViewDependentPaint& paint, const ViewDependentParams& params,
                               std::uint32_t face, glm::vec2 barycentrics, float light) {
    if (!paint.object) return glm::vec3(0);
    const PaintedObject& object = *paint.object;
    const glm::vec3 weights(1 - barycentrics.x - barycentrics.y, barycentrics);
    glm::vec3 sum(0);
    float total = 0, squares = 0;
    for (const ViewWeights::FaceView& view : object.weights->of(face)) {
        const auto& [a, b, c] = view.corners;
        float weight = a.weight * weights.x + b.weight * weights.y + c.weight * weights.z;
        if (params.followCamera)
            weight *= cameraWeight(paint, object.planned->plan.groups[view.group].view,
                                   pointOn(object.planned->surface, face, weights));
        const glm::vec2 position = a.position * weights.x + b.position * weights.y + c.position * weights.z;
        sum += weight * interpolatedLevels(object.textures.views[view.group], position, light);
        total += weight;
        squares += weight * weight;
    }
    if (!(total > 0)) return glm::vec3(0);
    return sum / (params.blend == Blend::Linear ? total : std::sqrt(squares));
}

Frame renderViewDependent(const scene::GBuffer& gbuffer, const std::vector<ViewDependentPaint>& paints,
                          const ViewDependentParams& params, const Task& task) {
    std::vector<const gradient::Gradient*> gradients;
    for (const ViewDependentPaint& paint : paints) gradients.push_back(paint.gradient);
    return shade(
        gbuffer, gradients,
        [&](std::uint16_t object, int x, int y, float light) {
            const glm::ivec2 pixel = pixelShowing(gbuffer, object, {x, y});
            if (pixel.x < 0) return glm::vec3(0);
            return viewDependentTexture(paints[object - 1u], params, gbuffer.faceId(pixel.x, pixel.y),
                                        gbuffer.barycentrics(pixel.x, pixel.y), light);
        },
        task);
}

}  // namespace chiaro::methods
