#include "core/scene/gbuffer.h"

#include "core/scene/occlusion.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace chiaro::scene {

namespace {

constexpr int tileSize = 32;

/// What is known at a point of the picture when looking for edges.
struct Probe {
    Hit hit;
    glm::vec3 point{0};
    glm::vec3 normal{0};
    float light = -1;  ///< without ambient occlusion, whose changes are never sudden on one surface
};

/// Casts one view into a G-buffer.
class GBufferCaster {
public:
    GBufferCaster(const RayCaster& caster, const OcclusionCaster& occlusion, GBuffer& gbuffer)
        : m_caster(caster),
          m_occlusion(occlusion),
          m_gbuffer(gbuffer),
          m_isEdge(gbuffer.width, gbuffer.height, 0),
          m_openness(gbuffer.width, gbuffer.height, 1) {}

    void castCentres(const Task& task) {
        const int columns = (m_gbuffer.width + tileSize - 1) / tileSize;
        const int rows = (m_gbuffer.height + tileSize - 1) / tileSize;
        Task::Steps steps(task, std::size_t(columns) * std::size_t(rows));
        tbb::parallel_for(0, columns * rows, [&](int tile) {
            castTile(tile % columns * tileSize, tile / columns * tileSize);
            steps.done();
        });
    }

    void castEdges(const Task& task) {
        collectEdgePixels();
        m_gbuffer.edgeSamples.resize(m_gbuffer.edgePixels.size() * GBuffer::samplesPerEdge);
        constexpr std::size_t chunk = 256;
        const std::size_t chunks = (m_gbuffer.edgePixels.size() + chunk - 1) / chunk;
        Task::Steps steps(task, chunks);
        tbb::parallel_for(std::size_t(0), chunks, [&](std::size_t c) {
            const std::size_t end = std::min((c + 1) * chunk, m_gbuffer.edgePixels.size());
            for (std::size_t i = c * chunk; i < end; ++i) castEdgePixel(i);
            steps.done();
        });
    }

private:
    // A picture of one pixel a side has 2 x 2 corners; those of neighbouring tiles are cast twice rather than
    // shared, so that tiles are independent.
    void castTile(int left, int top) {
        const int width = std::min(tileSize, m_gbuffer.width - left);
        const int height = std::min(tileSize, m_gbuffer.height - top);
        thread_local std::vector<Probe> centres;
        thread_local std::vector<Probe> corners;
        probe(glm::vec2(left, top) + 0.5f, width, height, centres);
        probe(glm::vec2(left, top), width + 1, height + 1, corners);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Probe& centre = centres[std::size_t(y * width + x)];
                store(centre, left + x, top + y);
                const Probe* above = &corners[std::size_t(y * (width + 1) + x)];
                const Probe* below = above + width + 1;
                m_isEdge(left + x, top + y) = differ(centre, above[0]) || differ(centre, above[1]) ||
                                              differ(centre, below[0]) || differ(centre, below[1]);
            }
    }

    /// Casts a grid of rays one pixel apart, 4 x 4 rays a packet.
    void probe(glm::vec2 origin, int width, int height, std::vector<Probe>& probes) {
        probes.resize(std::size_t(width) * std::size_t(height));
        std::array<glm::vec2, packetSize> positions;
        std::array<Hit, packetSize> hits;
        std::array<std::size_t, packetSize> places;
        for (int y0 = 0; y0 < height; y0 += 4)
            for (int x0 = 0; x0 < width; x0 += 4) {
                std::size_t count = 0;
                for (int y = y0; y < std::min(y0 + 4, height); ++y)
                    for (int x = x0; x < std::min(x0 + 4, width); ++x) {
                        positions[count] = origin + glm::vec2(x, y);
                        places[count++] = std::size_t(y * width + x);
                    }
                m_caster.cast({positions.data(), count}, {hits.data(), count});
                for (std::size_t i = 0; i < count; ++i) probes[places[i]] = lit(hits[i], positions[i]);
            }
    }

    Probe lit(const Hit& hit, glm::vec2 position) const {
        Probe probe{hit, {}, {}, -1};
        if (hit.object == 0) return probe;
        probe.point = m_caster.pointAt(position, hit.depth);
        probe.normal = m_caster.normal(hit, position);
        probe.light = m_occlusion.light({probe.point, probe.normal, hit.faceNormal});
        return probe;
    }

    float openness(const Probe& probe) const {
        return m_occlusion.openness({probe.point, probe.normal, probe.hit.faceNormal});
    }

    /// Of a sample of an edge pixel: that of the pixel's centre where it lies on the same piece of surface.
    float openness(const Probe& sample, int x, int y) const {
        const float depth = m_gbuffer.depth(x, y);
        const bool isSame = sample.hit.object == m_gbuffer.objectId(x, y) &&
                            glm::dot(sample.normal, m_gbuffer.normal(x, y)) > 0.95f &&
                            std::abs(sample.hit.depth - depth) < 4 * m_caster.pixelSize() * depth;
        return isSame ? m_openness(x, y) : openness(sample);
    }

    void store(const Probe& centre, int x, int y) {
        if (centre.hit.object != 0) m_openness(x, y) = openness(centre);
        m_gbuffer.light(x, y) = centre.hit.object == 0 ? -1 : centre.light * m_openness(x, y);
        m_gbuffer.objectId(x, y) = centre.hit.object;
        m_gbuffer.faceId(x, y) = centre.hit.face;
        m_gbuffer.barycentrics(x, y) = centre.hit.barycentrics;
        m_gbuffer.depth(x, y) = centre.hit.depth;
        m_gbuffer.normal(x, y) = centre.normal;
    }

    /// True when an edge that shows runs between two points of a pixel: another object, a jump in light, or a
    /// surface that does not continue from one to the other.
    bool differ(const Probe& a, const Probe& b) const {
        constexpr float lightStep = 0.06f;   // larger ones show as stairs
        constexpr float surfaceStep = 1.5f;  // pixels off the other point's tangent plane
        if (a.hit.object != b.hit.object) return true;
        if (a.hit.object == 0 || a.hit.face == b.hit.face) return false;
        if (std::abs(a.light - b.light) > lightStep) return true;
        const glm::vec3 between = b.point - a.point;
        const float step = std::max(std::abs(glm::dot(between, a.hit.faceNormal)),
                                    std::abs(glm::dot(between, b.hit.faceNormal)));
        return step > surfaceStep * m_caster.pixelSize() * std::min(a.hit.depth, b.hit.depth);
    }

    // The neighbours of an edge pixel are looked at closely too: what is thinner than a pixel may slip
    // between the rays of the one and show in the rays of the other.
    void collectEdgePixels() {
        for (int y = 0; y < m_gbuffer.height; ++y)
            for (int x = 0; x < m_gbuffer.width; ++x) {
                const bool left = x > 0 && m_isEdge(x - 1, y);
                const bool right = x + 1 < m_gbuffer.width && m_isEdge(x + 1, y);
                const bool above = y > 0 && m_isEdge(x, y - 1);
                const bool below = y + 1 < m_gbuffer.height && m_isEdge(x, y + 1);
                if (m_isEdge(x, y) || left || right || above || below)
                    m_gbuffer.edgePixels.push_back(std::uint32_t(y) * std::uint32_t(m_gbuffer.width) +
                                                   std::uint32_t(x));
            }
    }

    void castEdgePixel(std::size_t index) {
        // Hammersley points: one in each of 16 columns, 16 rows and 4 x 4 cells.
        static constexpr std::array<int, packetSize> reversed{0, 8, 4, 12, 2, 10, 6, 14,
                                                              1, 9, 5, 13, 3, 11, 7, 15};
        const std::uint32_t pixel = m_gbuffer.edgePixels[index];
        const int x = int(pixel % std::uint32_t(m_gbuffer.width));
        const int y = int(pixel / std::uint32_t(m_gbuffer.width));
        const glm::vec2 corner(x, y);
        std::array<glm::vec2, packetSize> positions;
        std::array<Hit, packetSize> hits;
        for (int i = 0; i < packetSize; ++i)
            positions[std::size_t(i)] =
                corner + (glm::vec2(i, reversed[std::size_t(i)]) + 0.5f) / float(packetSize);
        m_caster.cast(positions, hits);
        for (std::size_t i = 0; i < packetSize; ++i) {
            const Probe sample = lit(hits[i], positions[i]);
            const float light = sample.hit.object == 0 ? 0 : sample.light * openness(sample, x, y);
            m_gbuffer.edgeSamples[index * packetSize + i] = {sample.hit.object, light};
        }
    }

    static_assert(GBuffer::samplesPerEdge == packetSize);

    const RayCaster& m_caster;
    const OcclusionCaster& m_occlusion;
    GBuffer& m_gbuffer;
    Image<std::uint8_t> m_isEdge;
    ScalarImage m_openness;  ///< what ambient occlusion leaves of L at the centres
};

}  // namespace

GBuffer castGBuffer(const RayScene& rays, const std::vector<Light>& lights, const Camera& camera, int width,
                    int height, const Task& task) {
    GBuffer gbuffer;
    gbuffer.width = width;
    gbuffer.height = height;
    gbuffer.eye = camera.position();
    gbuffer.light = ScalarImage(width, height, -1);
    gbuffer.objectId = IdImage(width, height, 0);
    gbuffer.faceId = Image<std::uint32_t>(width, height, 0xFFFFFFFF);
    gbuffer.barycentrics = Image<glm::vec2>(width, height, glm::vec2(0));
    gbuffer.depth = ScalarImage(width, height, std::numeric_limits<float>::infinity());
    gbuffer.normal = ColorImage(width, height, glm::vec3(0));
    const RayCaster caster(rays.impl(), camera, width, height);
    const OcclusionCaster occlusion(rays.impl(), rays.occlusion(), lights);
    GBufferCaster cast(caster, occlusion, gbuffer);
    cast.castCentres(task.part(0, 0.6));
    cast.castEdges(task.part(0.6, 1));
    return gbuffer;
}

}  // namespace chiaro::scene
