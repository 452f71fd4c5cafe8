#include "core/methods/carried_texture.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace chiaro::methods {

using scene::SeenPoint;

namespace {

/// Weights of the four texels around a place between them, 0..1 (Catmull and Rom 1974): sharper than linear,
/// so that strokes don't soften when they are moved.
std::array<float, 4> cubicWeights(float t) {
    return {0.5f * t * (-1 + t * (2 - t)), 0.5f * (2 + t * t * (-5 + 3 * t)),
            0.5f * t * (1 + t * (4 - 3 * t)), 0.5f * t * t * (t - 1)};
}

/// Reads one object's texture in the frame that it was made for.
class TextureReader {
public:
    TextureReader(const FrameTexture& from, std::size_t object)
        : m_gbuffer(*from.view.gbuffer),
          m_texture(from.texture.objects[object]),
          m_object(std::uint16_t(object + 1)),
          m_pixel(2 * from.view.camera.halfExtent(m_gbuffer.width, m_gbuffer.height).x /
                  float(m_gbuffer.width)) {}

    /// What a surface point wears there; false when it can't be seen.
    bool read(const SeenPoint& point, glm::vec3& color, float& confidence) const {
        if (!point.exists() || !(point.facing > 0)) return false;
        const glm::vec2 size(m_gbuffer.width, m_gbuffer.height);
        if (glm::any(glm::lessThan(point.position, glm::vec2(0))) ||
            glm::any(glm::greaterThan(point.position, size)))
            return false;
        const glm::vec2 corner = point.position - 0.5f;
        const glm::ivec2 base(glm::floor(corner));
        const glm::vec2 t = corner - glm::vec2(base);
        // Beside the point the surface falls away with its slope.
        const float reach = m_pixel * point.depth;
        const float tolerance = 2 * reach * (1 + 1 / std::max(point.facing, 0.05f));
        std::array<std::array<bool, 4>, 4> shows{};
        bool all = true;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                const bool isSeen = sees(base + glm::ivec2(i - 1, j - 1), point.depth, tolerance);
                shows[std::size_t(j)][std::size_t(i)] = isSeen;
                all = all && isSeen;
            }
        const std::array<float, 4> linearX{0, 1 - t.x, t.x, 0}, linearY{0, 1 - t.y, t.y, 0};
        const auto weightsX = all ? cubicWeights(t.x) : linearX, weightsY = all ? cubicWeights(t.y) : linearY;
        glm::vec3 sum(0);
        float total = 0;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                if (!shows[std::size_t(j)][std::size_t(i)]) continue;
                const float weight = weightsX[std::size_t(i)] * weightsY[std::size_t(j)];
                sum += weight * texel(base + glm::ivec2(i - 1, j - 1));
                total += weight;
            }
        if (!(total > 0.01f)) return false;
        color = sum / total;
        confidence = std::min(total, 1.0f) * std::max(glm::smoothstep(0.0f, 0.6f, point.facing), 0.02f);
        return true;
    }

private:
    bool sees(glm::ivec2 pixel, float depth, float tolerance) const {
        return m_gbuffer.objectId.contains(pixel.x, pixel.y) &&
               m_gbuffer.objectId(pixel.x, pixel.y) == m_object &&
               std::abs(m_gbuffer.depth(pixel.x, pixel.y) - depth) <= tolerance;
    }
    const glm::vec3& texel(glm::ivec2 pixel) const {
        return m_texture.pixels(pixel.x - m_texture.origin.x, pixel.y - m_texture.origin.y);
    }

    const scene::GBuffer& m_gbuffer;
    const ObjectTexture& m_texture;
    std::uint16_t m_object;
    float m_pixel;  ///< a pixel's width at depth 1
};

/// Where a pixel's surface point lies in the other frame. A pixel that shows the object at its edge alone
/// goes along with a neighbour that the object fills.
SeenPoint seenOrBeside(const scene::GBuffer& gbuffer, const Image<SeenPoint>& seen, std::uint16_t object,
                       glm::ivec2 pixel) {
    const glm::ivec2 beside = pixelShowing(gbuffer, object, pixel);
    if (beside.x < 0) return {};
    SeenPoint point = seen(beside.x, beside.y);
    point.position -= glm::vec2(beside - pixel);
    return point;
}

CarriedTexture nothingKnown(const ObjectGuide& guide) {
    return {ColorImage(guide.covered.width(), guide.covered.height(), glm::vec3(0)),
            ScalarImage(guide.covered.width(), guide.covered.height(), 0.0f)};
}

}  // namespace

CarriedTexture stayed(const ObjectTexture& texture, const ObjectGuide& guide) {
    CarriedTexture carried = nothingKnown(guide);
    const glm::ivec2 shift = guide.origin - texture.origin;
    for (int y = 0; y < guide.covered.height(); ++y)
        for (int x = 0; x < guide.covered.width(); ++x) {
            if (!guide.covered(x, y) || !texture.covered.contains(x + shift.x, y + shift.y)) continue;
            if (!texture.covered(x + shift.x, y + shift.y)) continue;
            carried.pixels(x, y) = texture.pixels(x + shift.x, y + shift.y);
            carried.confidence(x, y) = 1;
        }
    return carried;
}

CarriedTexture moved(const FrameTexture& from, std::size_t object, const ObjectGuide& guide,
                     const scene::GBuffer& gbuffer, const Image<SeenPoint>& seen) {
    CarriedTexture carried = nothingKnown(guide);
    if (from.texture.objects[object].pixels.empty()) return carried;
    const TextureReader reader(from, object);
    const auto id = std::uint16_t(object + 1);
    tbb::parallel_for(0, guide.covered.height(), [&](int y) {
        for (int x = 0; x < guide.covered.width(); ++x) {
            if (!guide.covered(x, y)) continue;
            const SeenPoint point = seenOrBeside(gbuffer, seen, id, guide.origin + glm::ivec2(x, y));
            reader.read(point, carried.pixels(x, y), carried.confidence(x, y));
        }
    });
    return carried;
}

}  // namespace chiaro::methods
