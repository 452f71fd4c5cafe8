#include "core/export/view_pictures.h"

#include "core/methods/view_map.h"
#include "core/scene/guide.h"

#include <algorithm>

namespace chiaro::exporting {

namespace {

/// The place on a face that a position in a view's map shows, or the nearest on the face.
glm::vec2 placeOn(const methods::ViewWeights::FaceView& view, glm::vec2 position) {
    const glm::dvec2 origin(view.corners[0].position);
    const glm::dmat2 sides{glm::dvec2(view.corners[1].position) - origin,
                           glm::dvec2(view.corners[2].position) - origin};
    if (glm::determinant(sides) == 0) return glm::vec2(1.0f / 3);
    const glm::dvec2 place = glm::inverse(sides) * (glm::dvec2(position) - origin);
    glm::dvec3 weights = glm::max(glm::dvec3(1 - place.x - place.y, place), 0.0);
    weights /= weights.x + weights.y + weights.z;
    return {float(weights.y), float(weights.z)};
}

/// What a view's map shows, as a picture of light.
scene::GBuffer guideOf(const methods::ViewMap& map, std::size_t group, const methods::ViewWeights& weights,
                       std::size_t object, const SurfaceLight& light) {
    ScalarImage values(map.face.width(), map.face.height(), -1);
    IdImage ids(map.face.width(), map.face.height());
    for (int y = 0; y < values.height(); ++y)
        for (int x = 0; x < values.width(); ++x) {
            const std::uint32_t face = map.face(x, y);
            if (face == views::noFace) continue;
            const auto views = weights.of(face);
            const auto view = std::ranges::find(views, group, &methods::ViewWeights::FaceView::group);
            values(x, y) = light.at(object, face, placeOn(*view, map.center(x, y)));
            ids(x, y) = std::uint16_t(object + 1);
        }
    return scene::gbufferFromGuide(values, &ids);
}

}  // namespace

methods::ViewTextures paintViews(const methods::PlannedObject& planned, const methods::ViewWeights& weights,
                                 std::size_t object, const SurfaceLight& light, const GuidePainter& painter,
                                 const Task& task) {
    const std::size_t count = planned.plan.groups.size();
    methods::ViewTextures textures;
    textures.views.resize(count);
    for (std::size_t group = 0; group < count; ++group) {
        const methods::ViewMap map = methods::ViewMap::of(planned, group);
        if (map.face.empty()) continue;
        const Task part = task.part(double(group) / double(count), double(group + 1) / double(count));
        const methods::Frame frame = painter(guideOf(map, group, weights, object, light), part);
        Image<methods::PackedTexel> level(map.face.width(), map.face.height());
        std::ranges::transform(frame.texture.pixels(), level.pixels().begin(), methods::packed);
        textures.views[group] = {map.origin, {std::move(level)}};
    }
    return textures;
}

}  // namespace chiaro::exporting
