#include "core/metrics/coherence.h"

#include "core/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace chiaro::metrics {

namespace {

int objectAt(const MeasuredFrame& frame, glm::ivec2 pixel) {
    return frame.objects ? (*frame.objects)(pixel.x, pixel.y) : 1;
}

void checkSizes(const MeasuredFrame& first, const MeasuredFrame& second) {
    const ColorImage& a = *first.picture;
    const ColorImage& b = *second.picture;
    if (a.width() != b.width() || a.height() != b.height())
        throw Error("next picture", fmt::format("is {} x {} pixels", b.width(), b.height()),
                    fmt::format("the first is {} x {}, and both must be of one size", a.width(), a.height()));
}

/// 1 at the pixels of the first frame that can be compared with where `landing` takes them in the second.
template <class Landing>
Image<std::uint8_t> comparable(const MeasuredFrame& first, const MeasuredFrame& second, int block,
                               const Landing& landing) {
    checkSizes(first, second);
    Image<std::uint8_t> from = measurable(first, block);
    const Image<std::uint8_t> to = measurable(second, block);
    for (int y = 0; y < from.height(); ++y)
        for (int x = 0; x < from.width(); ++x) {
            if (!from(x, y)) continue;
            const std::optional<glm::ivec2> end = landing(glm::ivec2(x, y));
            from(x, y) = end && to.contains(end->x, end->y) && to(end->x, end->y) &&
                         objectAt(first, {x, y}) == objectAt(second, *end);
        }
    return from;
}

/// Mean d between pixels of the first frame and where `landing` takes them in the second.
template <class Landing>
Estimate coherence(const Bins& bins, const MeasuredFrame& first, const MeasuredFrame& second,
                   const MeasureParams& params, const Landing& landing) {
    MeasureParams::table().check(params);
    const Image<std::uint8_t> from = comparable(first, second, params.block, landing);
    const BinImage before = binned(*first.picture, bins), after = binned(*second.picture, bins);
    std::vector<double> distances;
    for (const glm::ivec2 pixel : drawPixels(from, params.pixels, params.seed, "next picture"))
        distances.push_back(distance(describe(before, {pixel, params.block}),
                                     describe(after, {*landing(pixel), params.block}), params.block));
    return estimate(distances);
}

/// The pixel in which a position lies; none for a position that isn't finite or is far outside any picture.
std::optional<glm::ivec2> pixelAt(glm::vec2 position) {
    constexpr float farthest = 1e6f;
    if (!(std::abs(position.x) < farthest && std::abs(position.y) < farthest)) return std::nullopt;
    return glm::ivec2(glm::floor(position));
}

std::optional<glm::ivec2> samePixel(glm::ivec2 pixel) {
    return pixel;
}

/// Where a pixel's surface point lands.
class SurfaceLanding {
public:
    SurfaceLanding(const MeasuredFrame& first, const SurfaceMotion& motion) : m_motion(motion) {
        const Image<glm::vec2>& displacement = *motion.displacement;
        const ColorImage& picture = *first.picture;
        if (displacement.width() != picture.width() || displacement.height() != picture.height())
            throw Error("motion",
                        fmt::format("is {} x {} pixels", displacement.width(), displacement.height()),
                        fmt::format("the picture is {} x {}, and both must be of one size", picture.width(),
                                    picture.height()));
    }
    std::optional<glm::ivec2> operator()(glm::ivec2 pixel) const {
        if (m_motion.seen && !(*m_motion.seen)(pixel.x, pixel.y)) return std::nullopt;
        return pixelAt(glm::vec2(pixel) + 0.5f + (*m_motion.displacement)(pixel.x, pixel.y));
    }

private:
    const SurfaceMotion& m_motion;
};

}  // namespace

Image<std::uint8_t> comparableInImage(const MeasuredFrame& first, const MeasuredFrame& second, int block) {
    return comparable(first, second, block, samePixel);
}

Estimate imageCoherence(const Bins& bins, const MeasuredFrame& first, const MeasuredFrame& second,
                        const MeasureParams& params) {
    return coherence(bins, first, second, params, samePixel);
}

Image<std::uint8_t> comparableOnObject(const MeasuredFrame& first, const MeasuredFrame& second,
                                       const SurfaceMotion& motion, int block) {
    return comparable(first, second, block, SurfaceLanding(first, motion));
}

Estimate objectCoherence(const Bins& bins, const MeasuredFrame& first, const MeasuredFrame& second,
                         const SurfaceMotion& motion, const MeasureParams& params) {
    return coherence(bins, first, second, params, SurfaceLanding(first, motion));
}

Image<std::uint8_t> seenInBoth(const scene::GBuffer& first, const Image<scene::SeenPoint>& landings,
                               const scene::GBuffer& second) {
    Image<std::uint8_t> seen(first.width, first.height, 0);
    for (int y = 0; y < first.height; ++y)
        for (int x = 0; x < first.width; ++x) {
            const scene::SeenPoint& point = landings(x, y);
            if (first.objectId(x, y) == 0 || !point.exists()) continue;
            const std::optional<glm::ivec2> end = pixelAt(point.position);
            if (!end || !second.objectId.contains(end->x, end->y) ||
                second.objectId(end->x, end->y) != first.objectId(x, y))
                continue;
            // Depth may differ as much as it does to the landing pixel's neighbours on the object.
            const float depth = second.depth(end->x, end->y);
            float slope = 0;
            for (const glm::ivec2 step : {glm::ivec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                const glm::ivec2 other = *end + step;
                if (second.objectId.contains(other.x, other.y) &&
                    second.objectId(other.x, other.y) == first.objectId(x, y))
                    slope = std::max(slope, std::abs(second.depth(other.x, other.y) - depth));
            }
            seen(x, y) = std::abs(point.depth - depth) <= 0.01f * depth + std::min(slope, 0.03f * depth);
        }
    return seen;
}

}  // namespace chiaro::metrics
