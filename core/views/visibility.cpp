#include "core/views/visibility.h"

#include "core/views/scan_conversion.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <span>

namespace chiaro::views {

namespace {

constexpr int tileSide = 32;
constexpr std::size_t chunk = 1024;  // faces a thread takes at once

/// A texel centre on a face.
struct Fragment {
    double depth;
    std::uint32_t face;
    std::uint32_t texel;  ///< in its tile
};

/// What is known of a face; several tiles may tell it at once, and only ever turn flags on.
struct FaceState {
    double facing = -1;
    std::atomic<bool> covers{false};
    std::atomic<bool> hidden{false};
};

/// One query on its way to an answer.
class GroupFinder {
public:
    GroupFinder(const Occluders& drawn, const View& view, const VisibilityQuery& query)
        : m_drawn(drawn),
          m_surface(drawn.surface()),
          m_query(query),
          m_projected(drawn.surface(), view),
          m_columns((view.size + tileSide - 1) / tileSide),
          m_states(std::make_unique<FaceState[]>(drawn.surface().faceCount())) {}

    std::vector<std::uint32_t> find(const Task& task) {
        forFaces([this](std::uint32_t face) {
            m_states[face].facing = m_projected.projector().facing(m_surface, face);
        });
        task.checkpoint();
        sortIntoTiles();
        tbb::parallel_for(0, m_columns * m_columns, [&](int tile) {
            task.checkpoint();
            judgeTile(tile);
        });
        forFaces([&](std::uint32_t face) {
            if (isWanted(face) && !m_states[face].covers && hiddenFromRays(face))
                m_states[face].hidden = true;
        });
        task.checkpoint();
        std::vector<std::uint32_t> found;
        for (std::uint32_t face = 0; face < m_surface.faceCount(); ++face)
            if (isWanted(face) && !m_states[face].hidden) found.push_back(face);
        return found;
    }

private:
    template <class Visit>
    void forFaces(Visit visit) const {
        const std::size_t count = m_surface.faceCount();
        tbb::parallel_for(std::size_t(0), (count + chunk - 1) / chunk, [&](std::size_t c) {
            for (std::size_t face = c * chunk; face < std::min((c + 1) * chunk, count); ++face)
                visit(std::uint32_t(face));
        });
    }

    bool isWanted(std::uint32_t face) const {
        return m_states[face].facing > m_query.minimumFacing &&
               (m_query.wanted == nullptr || (*m_query.wanted)[face] != 0);
    }
    bool hides(std::uint32_t face) const { return m_drawn.hides(face, m_states[face].facing); }

    /// Lists, tile after tile, the faces that are wanted or hide others there.
    void sortIntoTiles() {
        m_tileEnds.assign(std::size_t(m_columns * m_columns) + 1, 0);
        forTiles([this](std::size_t tile, std::uint32_t) { ++m_tileEnds[tile + 1]; });
        for (std::size_t i = 1; i < m_tileEnds.size(); ++i) m_tileEnds[i] += m_tileEnds[i - 1];
        m_tileFaces.resize(m_tileEnds.back());
        // Filling moves each tile's beginning to its end, which is the next one's beginning.
        forTiles([this](std::size_t tile, std::uint32_t face) { m_tileFaces[m_tileEnds[tile]++] = face; });
    }

    template <class Visit>
    void forTiles(Visit visit) const {
        for (std::uint32_t face = 0; face < m_surface.faceCount(); ++face) {
            if (!isWanted(face) && !hides(face)) continue;
            const TexelBox box = m_projected.boxOf(face);
            if (box.empty()) continue;
            for (int y = box.low.y / tileSide; y <= (box.high.y - 1) / tileSide; ++y)
                for (int x = box.low.x / tileSide; x <= (box.high.x - 1) / tileSide; ++x)
                    visit(std::size_t(y * m_columns + x), face);
        }
    }

    std::span<const std::uint32_t> facesOf(int tile) const {
        const std::size_t begin = tile > 0 ? m_tileEnds[std::size_t(tile) - 1] : 0;
        return std::span(m_tileFaces).subspan(begin, m_tileEnds[std::size_t(tile)] - begin);
    }

    void judgeTile(int tile) {
        thread_local std::vector<Fragment> fragments;
        thread_local std::vector<Fragment> sorted;
        collectFragments(tile, fragments);
        std::array<std::uint32_t, tileSide * tileSide + 1> ends{};
        for (const Fragment& fragment : fragments) ++ends[fragment.texel + 1];
        for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
        sorted.resize(fragments.size());
        for (const Fragment& fragment : fragments) sorted[ends[fragment.texel]++] = fragment;
        std::uint32_t begin = 0;
        for (std::size_t texel = 0; texel + 1 < ends.size(); ++texel) {
            judgeTexel(std::span(sorted).subspan(begin, ends[texel] - begin));
            begin = ends[texel];
        }
    }

    void collectFragments(int tile, std::vector<Fragment>& fragments) const {
        fragments.clear();
        const glm::ivec2 corner(tile % m_columns * tileSide, tile / m_columns * tileSide);
        for (const std::uint32_t face : facesOf(tile)) {
            const std::optional<FaceScan> scan = FaceScan::of(m_projected, face);
            if (!scan) continue;
            const TexelBox box = m_projected.boxOf(face);
            scan->scan({glm::max(box.low, corner), glm::min(box.high, corner + tileSide)}, [&](int x, int y,
                                                                                               double depth) {
                fragments.push_back({depth, face, std::uint32_t((y - corner.y) * tileSide + x - corner.x)});
            });
        }
    }

    /// Tells which of the faces over a texel centre are hidden there.
    void judgeTexel(std::span<Fragment> fragments) {
        std::ranges::sort(fragments, {}, &Fragment::depth);
        for (const Fragment& fragment : fragments) {
            FaceState& state = m_states[fragment.face];
            if (!isWanted(fragment.face)) continue;
            state.covers.store(true, std::memory_order_relaxed);
            if (state.hidden.load(std::memory_order_relaxed)) continue;
            const double nearer = fragment.depth - slackAt(fragment);
            for (const Fragment& other : fragments) {
                if (other.depth >= nearer) break;
                if (!hides(other.face) || m_surface.adjacent(fragment.face, other.face)) continue;
                state.hidden.store(true, std::memory_order_relaxed);
                break;
            }
        }
    }

    /// How far in depth rounding may put a face and one coincident with it apart.
    double slackAt(const Fragment& fragment) const {
        const double facing = m_states[fragment.face].facing;
        const double slope = std::sqrt(std::max(1 - facing * facing, 0.0)) / facing;
        return m_drawn.slack(facing) + edgeTolerance * slope * m_projected.texelSize(fragment.depth);
    }

    bool hiddenFromRays(std::uint32_t face) const {
        const Projector& projector = m_projected.projector();
        const double facing = m_states[face].facing;
        if (!projector.perspective())
            return m_drawn.hidden(face, projector.towardsEye(glm::dvec3(0)), facing);
        for (int probe = 0; probe < probeCount; ++probe) {
            const glm::dvec3 point = probeOf(m_surface, face, probe);
            const double depth = projector.project(point).z;
            if (m_drawn.hidden(face, point, projector.towardsEye(point), facing, depth)) return true;
        }
        return false;
    }

    const Occluders& m_drawn;
    const Surface& m_surface;
    const VisibilityQuery& m_query;
    ProjectedMesh m_projected;
    int m_columns;
    std::unique_ptr<FaceState[]> m_states;
    std::vector<std::size_t> m_tileEnds;
    std::vector<std::uint32_t> m_tileFaces;
};

}  // namespace

std::vector<std::uint32_t> visibleFaces(const Occluders& drawn, const View& view,
                                        const VisibilityQuery& query, const Task& task) {
    return GroupFinder(drawn, view, query).find(task);
}

}  // namespace chiaro::views
