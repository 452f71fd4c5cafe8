#include "core/methods/object_guide.h"

#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace chiaro::methods {

namespace {

struct Bounds {
    glm::ivec2 low{std::numeric_limits<int>::max()};
    glm::ivec2 high{-1};

    void add(int x, int y) {
        low = glm::min(low, glm::ivec2(x, y));
        high = glm::max(high, glm::ivec2(x, y));
    }
};

/// A pixel that shows an object at its edge alone.
struct Fringe {
    glm::ivec2 pixel{0};
    float light = 0;
};

class GuideCutter {
public:
    GuideCutter(const scene::GBuffer& gbuffer, std::size_t objects)
        : m_gbuffer(gbuffer), m_bounds(objects), m_fringes(objects) {
        for (int y = 0; y < gbuffer.height; ++y) addRow(y);
        for (std::size_t edge = 0; edge < gbuffer.edgePixels.size(); ++edge) addEdge(edge);
    }

    ObjectGuide cut(std::size_t index) const {
        const Bounds& bounds = m_bounds[index];
        if (bounds.high.x < 0) return {};
        const glm::ivec2 size = bounds.high - bounds.low + 1;
        ObjectGuide guide{bounds.low, Image<std::uint8_t>(size.x, size.y), ScalarImage(size.x, size.y)};
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec2 pixel = bounds.low + glm::ivec2(x, y);
                if (m_gbuffer.objectId(pixel.x, pixel.y) != index + 1) continue;
                guide.covered(x, y) = 1;
                guide.light(x, y) = m_gbuffer.light(pixel.x, pixel.y);
            }
        for (const Fringe& fringe : m_fringes[index]) {
            const glm::ivec2 at = fringe.pixel - bounds.low;
            guide.covered(at.x, at.y) = 1;
            guide.light(at.x, at.y) = fringe.light;
        }
        return guide;
    }

private:
    std::size_t indexOf(std::uint16_t object) const {
        if (object > m_bounds.size())
            throw Error("object " + std::to_string(object), "wears no sample",
                        fmt::format("the picture may show objects 1..{}", m_bounds.size()));
        return object - 1u;
    }

    void addRow(int y) {
        const std::span<const std::uint16_t> ids = m_gbuffer.objectId.row(y);
        for (int x = 0; x < m_gbuffer.width; ++x) {
            const std::uint16_t object = ids[std::size_t(x)];
            if (object == 0) continue;
            const int begin = x;
            while (x + 1 < m_gbuffer.width && ids[std::size_t(x) + 1] == object) ++x;
            Bounds& bounds = m_bounds[indexOf(object)];
            bounds.add(begin, y);
            bounds.add(x, y);
        }
    }

    void addEdge(std::size_t edge) {
        constexpr std::size_t count = scene::GBuffer::samplesPerEdge;
        const auto samples = std::span(m_gbuffer.edgeSamples).subspan(edge * count, count);
        const auto width = std::uint32_t(m_gbuffer.width);
        const glm::ivec2 pixel(m_gbuffer.edgePixels[edge] % width, m_gbuffer.edgePixels[edge] / width);
        const std::uint16_t centre = m_gbuffer.objectId(pixel.x, pixel.y);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint16_t object = samples[i].object;
            const auto same = [object](const scene::SurfaceSample& other) { return other.object == object; };
            if (object == 0 || object == centre || std::ranges::any_of(samples.first(i), same)) continue;
            float sum = 0;
            for (const scene::SurfaceSample& sample : samples)
                if (same(sample)) sum += sample.light;
            const std::size_t index = indexOf(object);
            m_bounds[index].add(pixel.x, pixel.y);
            m_fringes[index].push_back({pixel, sum / float(std::ranges::count_if(samples, same))});
        }
    }

    const scene::GBuffer& m_gbuffer;
    std::vector<Bounds> m_bounds;
    std::vector<std::vector<Fringe>> m_fringes;
};

}  // namespace

std::vector<ObjectGuide> objectGuides(const scene::GBuffer& gbuffer, std::size_t objects) {
    const GuideCutter cutter(gbuffer, objects);
    std::vector<ObjectGuide> guides(objects);
    tbb::parallel_for(std::size_t(0), objects, [&](std::size_t i) { guides[i] = cutter.cut(i); });
    return guides;
}

void extend(ObjectGuide& guide, const ObjectGuide& other) {
    if (other.empty()) return;
    if (guide.empty()) {
        guide = other;
        return;
    }
    const auto size = [](const ObjectGuide& one) {
        return glm::ivec2(one.covered.width(), one.covered.height());
    };
    const glm::ivec2 low = glm::min(guide.origin, other.origin);
    const glm::ivec2 high = glm::max(guide.origin + size(guide), other.origin + size(other));
    ObjectGuide both{low, Image<std::uint8_t>(high.x - low.x, high.y - low.y),
                     ScalarImage(high.x - low.x, high.y - low.y)};
    for (const ObjectGuide* one : {&other, static_cast<const ObjectGuide*>(&guide)}) {
        const glm::ivec2 shift = one->origin - low;
        for (int y = 0; y < one->covered.height(); ++y)
            for (int x = 0; x < one->covered.width(); ++x) {
                if (!one->covered(x, y)) continue;
                both.covered(x + shift.x, y + shift.y) = 1;
                both.light(x + shift.x, y + shift.y) = one->light(x, y);
            }
    }
    guide = std::move(both);
}

}  // namespace chiaro::methods
