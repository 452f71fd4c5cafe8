#include "core/methods/view_aligned.h"

#include <algorithm>

namespace chiaro::methods {

const ParameterTable<ViewAlignedParams>& ViewAlignedParams::table() {
    static const auto table =
        ParameterTable<ViewAlignedParams>()
            .add(&ViewAlignedParams::density,
                 ParameterSpec::real("density", "Stroke density", "texel/px", 0.1, 10, 0.05,
                                     "Texture pixels per screen pixel; larger makes smaller strokes"))
            .add(&ViewAlignedParams::followZoom,
                 ParameterSpec::boolean("follow-zoom", "Follow zoom",
                                        "Scale the strokes with the object, in octaves that cross-fade"));
    return table;
}

namespace {

constexpr std::size_t maximumFollowed = 16384;

struct FollowedVertex {
    float facing;    ///< n.v in the earlier view
    glm::vec2 from;  ///< screen position in the earlier view, pixels, y down
    glm::vec2 to;
    float growth;  ///< projected size in the later view over that in the earlier
};

glm::vec2 screenPosition(glm::vec4 clip, const ObjectView& view) {
    return (glm::vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * glm::vec2(view.width, view.height);
}

/// Pixels per object-space unit at clip distance w.
float projectedScale(const ObjectView& view, float w) {
    const float objectScale = std::cbrt(std::abs(glm::determinant(glm::mat3(view.objectToView))));
    return objectScale * view.projection[1][1] * float(view.height) * 0.5f / w;
}

bool inView(glm::vec4 clip) {
    return clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w &&
           std::abs(clip.z) <= clip.w;
}

std::vector<FollowedVertex> facingVertices(const scene::Mesh& mesh, const ObjectView& before,
                                           const ObjectView& after) {
    const glm::mat4 clipBefore = before.projection * before.objectToView;
    const glm::mat4 clipAfter = after.projection * after.objectToView;
    const glm::mat3 normalToView = glm::transpose(glm::inverse(glm::mat3(before.objectToView)));
    const std::size_t stride = (mesh.positions.size() + maximumFollowed - 1) / maximumFollowed;
    std::vector<FollowedVertex> vertices;
    for (std::size_t i = 0; i < mesh.positions.size(); i += stride) {
        const glm::vec4 position(mesh.positions[i], 1);
        const glm::vec4 from = clipBefore * position;
        const glm::vec4 to = clipAfter * position;
        if (!inView(from) || to.w <= 0) continue;
        const glm::vec3 towardsEye = -glm::vec3(before.objectToView * position);
        const float facing =
            glm::dot(glm::normalize(normalToView * mesh.normals[i]), glm::normalize(towardsEye));
        if (!(facing > 0)) continue;
        vertices.push_back({facing, screenPosition(from, before), screenPosition(to, after),
                            projectedScale(after, to.w) / projectedScale(before, from.w)});
    }
    return vertices;
}

/// Bilinear with repeat, at a position in texels whose integers lie between texels' centres as in OpenGL.
glm::vec3 repeatedTexel(const ColorImage& level, glm::vec2 position) {
    const int n = level.width();
    const glm::vec2 corner = position - 0.5f;
    const glm::vec2 base = glm::floor(corner);
    const glm::vec2 t = corner - base;
    const auto wrap = [n](float value) {
        const int index = int(value - std::floor(value / float(n)) * float(n));
        return index == n ? 0 : index;
    };
    const int x0 = wrap(base.x);
    const int y0 = wrap(base.y);
    const int x1 = x0 + 1 == n ? 0 : x0 + 1;
    const int y1 = y0 + 1 == n ? 0 : y0 + 1;
    return glm::mix(glm::mix(level(x0, y0), level(x1, y0), t.x), glm::mix(level(x0, y1), level(x1, y1), t.x),
                    t.y);
}

glm::vec3 stackTexel(const synthesis::LevelStack& stack, glm::vec2 position, float light) {
    const int last = int(stack.levels.size()) - 1;
    const float slice = glm::clamp(light * float(last + 1) - 0.5f, 0.0f, float(last));
    const int lower = std::min(int(slice), last);
    const float t = slice - float(lower);
    const glm::vec3 texel = repeatedTexel(stack.levels[std::size_t(lower)], position);
    if (t == 0) return texel;
    return glm::mix(texel, repeatedTexel(stack.levels[std::size_t(lower) + 1], position), t);
}

/// `scale` texels fall on a pixel: several taps when that is more than one, spread so that nothing jumps
/// at 1.
glm::vec3 filteredTexel(const synthesis::LevelStack& stack, glm::vec2 position, float scale, float light) {
    const int taps = scale <= 1 ? 1 : scale <= 2 ? 2 : 4;
    if (taps == 1) return stackTexel(stack, position, light);
    const float step = (scale - 1) / float(taps - 1);
    const float first = -(scale - 1) / 2;
    glm::vec3 sum(0);
    for (int j = 0; j < taps; ++j)
        for (int i = 0; i < taps; ++i)
            sum += stackTexel(stack, position + first + step * glm::vec2(i, j), light);
    return sum / float(taps * taps);
}

}  // namespace

TexturePlacement follow(const TexturePlacement& placement, const scene::Mesh& mesh, const ObjectView& before,
                        const ObjectView& after, const ViewAlignedParams& params) {
    std::vector<FollowedVertex> vertices = facingVertices(mesh, before, after);
    if (vertices.empty()) return placement;
    const std::size_t tenth = std::max<std::size_t>(1, vertices.size() / 10);
    std::nth_element(vertices.begin(), vertices.begin() + std::ptrdiff_t(tenth) - 1, vertices.end(),
                     [](const FollowedVertex& a, const FollowedVertex& b) { return a.facing > b.facing; });
    glm::dvec2 from(0);
    glm::dvec2 to(0);
    double growth = 0;
    for (std::size_t i = 0; i < tenth; ++i) {
        from += vertices[i].from;
        to += vertices[i].to;
        growth += std::log(double(vertices[i].growth));
    }
    from /= double(tenth);
    to /= double(tenth);
    const double ratio = std::exp(growth / double(tenth));
    const double magnified = params.followZoom ? ratio : 1;
    return {glm::vec2(to - (from - glm::dvec2(placement.offset)) * magnified), float(placement.zoom * ratio)};
}

ZoomOctaves zoomOctaves(float zoom) {
    const float octave = std::log2(zoom);
    const float fraction = octave - std::floor(octave);
    const float faded = std::clamp(3 * fraction - 1, 0.0f, 1.0f);
    const float norm = 1 / std::sqrt(faded * faded + (1 - faded) * (1 - faded));
    return {std::exp2(-fraction), std::exp2(1 - fraction), (1 - faded) * norm, faded * norm};
}

glm::vec3 viewAlignedTexture(const ViewAlignedPaint& paint, const ViewAlignedParams& params,
                             glm::vec2 position, float light) {
    const glm::vec2 anchored = position - paint.placement.offset;
    const ZoomOctaves octaves = zoomOctaves(params.followZoom ? paint.placement.zoom : 1.0f);
    const auto octave = [&](float octaveScale, float weight) {
        if (weight == 0) return glm::vec3(0);
        const float scale = octaveScale * float(params.density);
        return weight * filteredTexel(*paint.levels, anchored * scale, scale, light);
    };
    return octave(octaves.scale, octaves.weight) + octave(octaves.nextScale, octaves.nextWeight);
}

Frame renderViewAligned(const scene::GBuffer& gbuffer, const std::vector<ViewAlignedPaint>& paints,
                        const ViewAlignedParams& params, const Task& task) {
    std::vector<const gradient::Gradient*> gradients;
    for (const ViewAlignedPaint& paint : paints) gradients.push_back(paint.gradient);
    const TextureLookup texture = [&](std::uint16_t object, int x, int y, float light) {
        return viewAlignedTexture(paints[object - 1u], params, glm::vec2(x, y) + 0.5f, light);
    };
    return shade(gbuffer, gradients, texture, task);
}

}  // namespace chiaro::methods
