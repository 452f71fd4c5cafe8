#include "core/methods/object_texels.h"

#include "core/methods/texture_atlas.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace chiaro::methods {

namespace {

/// How the views' maps lie in the texture: each texel of it shows a square of so many of theirs.
struct MapLayout {
    TextureAtlas atlas;
    int reduction = 1;
};

MapLayout layoutOf(const ViewTextures& textures, int levelCount, int largestSide, std::size_t byteLimit) {
    for (int reduction = 1;; reduction *= 2) {
        std::vector<glm::ivec2> sizes;
        bool fits = true;
        for (const ViewTexture& view : textures.views) {
            const glm::ivec2 size = view.levels.empty()
                                        ? glm::ivec2(0)
                                        : glm::ivec2(view.levels[0].width(), view.levels[0].height());
            sizes.push_back((size + reduction - 1) / reduction);
            fits &= sizes.back().x <= largestSide && sizes.back().y <= largestSide;
        }
        TextureAtlas atlas = packAtlas(sizes, largestSide);
        fits &= atlas.texelCount() * std::size_t(levelCount) * sizeof(DifferenceTexel) <= byteLimit &&
                atlas.pageCount * levelCount <= largestSide;
        if (fits) return {std::move(atlas), reduction};
    }
}

float largestDifference(const ViewTextures& textures) {
    int largest = 0;
    for (const ViewTexture& view : textures.views)
        for (const Image<PackedTexel>& level : view.levels)
            for (const PackedTexel texel : level.pixels())
                largest = std::max({largest, std::abs(texel.x), std::abs(texel.y), std::abs(texel.z)});
    return unpacked(PackedTexel(glm::int16(largest))).x;
}

/// The mean of the texels that a texel of the texture stands for.
glm::vec3 reduced(const Image<PackedTexel>& level, glm::ivec2 corner, int reduction) {
    if (reduction == 1) return unpacked(level(corner.x, corner.y));
    glm::vec3 sum(0);
    float count = 0;
    for (int y = corner.y; y < std::min(corner.y + reduction, level.height()); ++y)
        for (int x = corner.x; x < std::min(corner.x + reduction, level.width()); ++x) {
            sum += unpacked(level(x, y));
            ++count;
        }
    return sum / count;
}

void addTexels(ObjectTexels& result, const ViewTextures& textures, const MapLayout& layout) {
    const TextureAtlas& atlas = layout.atlas;
    result.layout.range = DifferenceRange::of(largestDifference(textures));
    result.texels.assign(atlas.texelCount() * std::size_t(result.layout.levelCount), noDifference);
    tbb::parallel_for(std::size_t(0), textures.views.size(), [&](std::size_t i) {
        const ViewTexture& view = textures.views[i];
        const TextureAtlas::Place& place = atlas.places[i];
        for (std::size_t l = 0; l < view.levels.size(); ++l) {
            const Image<PackedTexel>& level = view.levels[l];
            const std::size_t layer = std::size_t(place.page) * std::size_t(result.layout.levelCount) + l;
            ColorImage row((level.width() + layout.reduction - 1) / layout.reduction, 1);
            for (int y = 0; y * layout.reduction < level.height(); ++y) {
                for (int x = 0; x < row.width(); ++x)
                    row(x, 0) = reduced(level, glm::ivec2(x, y) * layout.reduction, layout.reduction);
                const std::size_t line =
                    layer * std::size_t(atlas.pageSize.y) + std::size_t(place.origin.y + y);
                encodeDifferences(row, result.layout.range,
                                  result.texels.data() + line * std::size_t(atlas.pageSize.x) +
                                      std::size_t(place.origin.x));
            }
        }
    });
}

/// The factors of (point, 1) for a function that is affine in space, about `middle`.
template <class Function>
glm::dvec4 affine(const glm::dvec3& middle, double step, const Function& function) {
    const double base = function(middle);
    glm::dvec4 factors(0, 0, 0, base);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 point = middle;
        point[axis] += step;
        factors[axis] = (function(point) - base) / (point[axis] - middle[axis]);
    }
    return factors;
}

/// What `ObjectTexels::views` has of a view.
std::array<glm::vec4, 4> viewTexels(const views::Surface& surface, const views::View& view, glm::ivec2 origin,
                                    const TextureAtlas::Place& place, const MapLayout& layout) {
    const views::Projector projector(view);
    const bool perspective = projector.perspective();
    const double step = surface.radius() / 16;
    // Texels times the depth are affine in space, in perspective; without, texels are.
    const auto divisor = [&](const glm::dvec3& projected) { return perspective ? projected.z : 1.0; };
    const auto coordinate = [&](int axis) {
        const double first = place.origin[axis] - double(origin[axis]) / layout.reduction;
        return affine(surface.center(), step, [&](const glm::dvec3& point) {
            const glm::dvec3 projected = projector.project(point);
            return (projected[axis] / layout.reduction + first) / layout.atlas.pageSize[axis] *
                   divisor(projected);
        });
    };
    const glm::dvec4 depth = affine(
        surface.center(), step, [&](const glm::dvec3& point) { return divisor(projector.project(point)); });
    const double page = double(place.page) / layout.atlas.pageCount;
    return {glm::vec4(coordinate(0)), glm::vec4(coordinate(1)), glm::vec4(depth),
            glm::vec4(glm::dvec4(glm::normalize(view.direction), page))};
}

/// A face's weights in 16 bits: the largest is as large as can be.
void addWeights(ObjectTexels& result, std::span<const ViewWeights::FaceView> views) {
    float largest = 0;
    for (const auto& view : views)
        for (const auto& corner : view.corners) largest = std::max(largest, corner.weight);
    result.faceViews.emplace_back(result.weights.size(), views.size());
    for (const auto& [group, corners] : views) {
        glm::u16vec4& entry = result.weights.emplace_back(group, 0, 0, 0);
        for (std::size_t k = 0; k < 3; ++k)
            entry[int(k) + 1] = glm::uint16(std::max(std::round(corners[k].weight / largest * 65535), 1.0f));
    }
}

}  // namespace

ObjectTexels objectTexels(const PaintedObject& object, int largestSide, std::size_t byteLimit) {
    const views::Surface& surface = object.planned->surface;
    const auto& groups = object.planned->plan.groups;
    ObjectTexels result;
    result.layout.middle = surface.center();
    for (const ViewTexture& view : object.textures.views)
        result.layout.levelCount = std::max(result.layout.levelCount, int(view.levels.size()));
    if (result.layout.levelCount == 0) return result;
    const MapLayout layout = layoutOf(object.textures, result.layout.levelCount, largestSide, byteLimit);
    result.layout.pageCount = layout.atlas.pageCount;
    result.layout.size =
        glm::ivec3(layout.atlas.pageSize, result.layout.levelCount * result.layout.pageCount);
    addTexels(result, object.textures, layout);
    double finest = 0;
    for (const views::FaceGroup& group : groups) finest = std::max(finest, group.view.texelsPerUnit());
    result.layout.texelSize = 1 / finest;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const auto texels = viewTexels(surface, groups[i].view, object.textures.views[i].origin,
                                       layout.atlas.places[i], layout);
        result.views.insert(result.views.end(), texels.begin(), texels.end());
        result.layout.isPerspective |= groups[i].view.projection == views::Projection::Perspective;
    }
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face) {
        for (std::size_t k = 0; k < 3; ++k)
            result.corners.emplace_back(surface.corner(face, k) - surface.center());
        addWeights(result, object.weights->of(face));
    }
    return result;
}

}  // namespace chiaro::methods
