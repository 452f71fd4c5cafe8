#include "widgets/viewport/view_snapshot.h"

#include <algorithm>

namespace chiaro::widgets {

namespace {

std::shared_ptr<const synthesis::LevelStack> noTexture() {
    static const auto stack = std::make_shared<const synthesis::LevelStack>(
        synthesis::LevelStack{{ColorImage(1, 1, glm::vec3(0))}, {}});
    return stack;
}

/// The texture of a coarse picture's pixels, at their middle: it keeps its place and size on the screen.
methods::TextureLookup levelLookup(const ViewSnapshot& snapshot, int coarseness) {
    methods::ViewAlignedParams params = snapshot.params;
    params.density *= coarseness;
    std::vector<methods::ViewAlignedPaint> paints;
    for (std::size_t i = 0; i < snapshot.paints.size(); ++i) {
        const ViewportPaint& paint = snapshot.paints[i];
        methods::TexturePlacement placement = snapshot.placements[i];
        placement.offset /= float(coarseness);
        const bool textured = paint.levels && !paint.levels->levels.empty();
        paints.push_back({textured ? paint.levels.get() : noTexture().get(), &paint.gradient, placement});
    }
    return [paints = std::move(paints), params](std::uint16_t object, int x, int y, float light) {
        return methods::viewAlignedTexture(paints[object - 1u], params, glm::vec2(x, y) + 0.5f, light);
    };
}

methods::TextureLookup viewTextureLookup(const ViewSnapshot& snapshot, int coarseness) {
    return [&snapshot, coarseness](std::uint16_t object, int x, int y, float) {
        if (!snapshot.viewTexture) return glm::vec3(0);
        const methods::TexturePlacement& motion = snapshot.motions[object - 1u];
        const glm::vec2 position = (glm::vec2(x, y) + 0.5f) * float(coarseness);
        return snapshot.viewTexture->difference(object - 1u, (position - motion.offset) / motion.zoom);
    };
}

}  // namespace

ViewSnapshot ViewSnapshot::of(ViewState& state, const std::string& method, QSize pixels) {
    state.follow(pixels);
    ViewSnapshot snapshot{.scene = state.scene(),
                          .camera = state.camera,
                          .paints = {},
                          .placements = state.placements(),
                          .method = method,
                          .params = state.params,
                          .viewTexture = state.viewTexture,
                          .motions = {},
                          .painted = {},
                          .viewDependent = state.viewDependent,
                          .background = state.background,
                          .pixels = pixels};
    if (snapshot.viewTexture) snapshot.motions = state.textureMotions(*snapshot.viewTexture, pixels);
    for (std::size_t i = 0; i < snapshot.scene.objects.size(); ++i) {
        snapshot.paints.push_back(state.paint(snapshot.scene.objects[i].sample));
        snapshot.painted.push_back(state.paintedObject(i));
    }
    return snapshot;
}

bool sameSurfaces(const scene::Scene& a, const scene::Scene& b) {
    return std::ranges::equal(a.objects, b.objects, [](const scene::Object& x, const scene::Object& y) {
        return x.mesh == y.mesh && x.transform == y.transform && x.visible == y.visible;
    });
}

methods::Frame shaded(const ViewSnapshot& snapshot, const scene::GBuffer& gbuffer, int coarseness,
                      const Task& task) {
    if (snapshot.method == "view-dependent") {
        std::vector<methods::ViewDependentPaint> paints;
        for (std::size_t i = 0; i < snapshot.paints.size(); ++i) {
            const glm::mat4 worldToObject = glm::inverse(snapshot.scene.objects[i].transform);
            paints.push_back({snapshot.painted[i].get(), &snapshot.paints[i].gradient,
                              glm::vec3(worldToObject * glm::vec4(gbuffer.eye, 1))});
        }
        return methods::renderViewDependent(gbuffer, paints, snapshot.viewDependent, task);
    }
    std::vector<const gradient::Gradient*> gradients;
    for (const ViewportPaint& paint : snapshot.paints) gradients.push_back(&paint.gradient);
    const methods::TextureLookup texture = snapshot.method == "image-based"
                                               ? viewTextureLookup(snapshot, coarseness)
                                               : levelLookup(snapshot, coarseness);
    return methods::shade(gbuffer, gradients, texture, task);
}

}  // namespace chiaro::widgets
