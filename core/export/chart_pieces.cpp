#include "core/export/chart_pieces.h"

#include "core/methods/view_map.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace chiaro::exporting {

namespace {

constexpr int smoothingRounds = 4;
/// A face may go with its neighbours to a view that sees it at least this well, compared with its best one.
constexpr float goodEnough = 0.75f;
/// Pieces with less of the object's area than this are specks.
constexpr double speck = 0.01;
/// A speck must face the way of what it joins at least this well: a little better than charts need.
constexpr double facingOfSpecks = leastFacing + 0.1;

/// For each face the group that shows it; noGroup for a face that is in none.
class GroupChoice {
public:
    explicit GroupChoice(const PlacedSurface& surface)
        : m_surface(surface), m_memberships(surface.planned()), m_groups(surface.faceCount(), noGroup) {}

    std::vector<std::uint32_t> choose() {
        for (std::uint32_t face = 0; face < m_groups.size(); ++face) {
            const auto groups = m_memberships.of(face);
            const auto best = std::ranges::max_element(groups, {}, &methods::FaceGroups::Membership::facing);
            if (best != groups.end()) m_groups[face] = best->group;
        }
        for (int round = 0; round < smoothingRounds; ++round)
            for (std::uint32_t face = 0; face < m_groups.size(); ++face) goWithNeighbours(face);
        return std::move(m_groups);
    }

private:
    void goWithNeighbours(std::uint32_t face) {
        const auto neighbours = m_surface.neighbours(face);
        const auto neighboursIn = [&](std::uint32_t group) {
            return std::ranges::count_if(neighbours, [&](auto other) { return m_groups[other] == group; });
        };
        float best = 0;
        for (const auto& membership : m_memberships.of(face)) best = std::max(best, membership.facing);
        auto most = neighboursIn(m_groups[face]);
        for (const auto& membership : m_memberships.of(face)) {
            if (membership.facing < goodEnough * best) continue;
            const auto count = neighboursIn(membership.group);
            if (count <= most) continue;
            most = count;
            m_groups[face] = membership.group;
        }
    }

    const PlacedSurface& m_surface;
    const methods::FaceGroups m_memberships;
    std::vector<std::uint32_t> m_groups;
};

/// Lets specks go with what surrounds them, the smallest first.
class SpeckJoiner {
public:
    SpeckJoiner(const PlacedSurface& surface, std::vector<Piece> pieces)
        : m_surface(surface),
          m_pieces(std::move(pieces)),
          m_areas(m_pieces.size(), 0),
          m_crosses(m_pieces.size(), glm::dvec3(0)),
          m_pieceOf(surface.faceCount(), nowhere) {
        for (std::size_t i = 0; i < m_pieces.size(); ++i)
            for (const std::uint32_t face : m_pieces[i].faces) {
                m_areas[i] += surface.area(face);
                m_crosses[i] += surface.cross(face);
                m_pieceOf[face] = i;
            }
    }

    std::vector<Piece> join() {
        const double total = std::accumulate(m_areas.begin(), m_areas.end(), 0.0);
        std::vector<std::size_t> order(m_pieces.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return m_areas[i]; });
        for (const std::size_t i : order)
            if (m_areas[i] < speck * total) joinSpeck(i);
        std::erase_if(m_pieces, [](const Piece& piece) { return piece.faces.empty(); });
        return std::move(m_pieces);
    }

private:
    static constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

    /// Gives a speck to the piece that most of its border touches, if that looks about the same way.
    void joinSpeck(std::size_t i) {
        std::map<std::size_t, int> touching;
        for (const std::uint32_t face : m_pieces[i].faces)
            for (const std::uint32_t other : m_surface.neighbours(face))
                if (m_pieceOf[other] != i && m_pieceOf[other] != nowhere) ++touching[m_pieceOf[other]];
        std::size_t chosen = nowhere;
        int most = 0;
        for (const auto& [piece, count] : touching) {
            if (count <= most || !looksTheWayOf(i, piece)) continue;
            chosen = piece;
            most = count;
        }
        if (chosen == nowhere) return;
        for (const std::uint32_t face : m_pieces[i].faces) m_pieceOf[face] = chosen;
        if (m_areas[i] > m_areas[chosen]) m_pieces[chosen].group = m_pieces[i].group;
        m_areas[chosen] += std::exchange(m_areas[i], 0);
        m_crosses[chosen] += m_crosses[i];
        const std::vector<std::uint32_t> faces = std::move(m_pieces[i].faces);
        m_pieces[i].faces.clear();
        m_pieces[chosen].faces.insert(m_pieces[chosen].faces.end(), faces.begin(), faces.end());
    }

    bool looksTheWayOf(std::size_t i, std::size_t piece) const {
        const glm::dvec3 sum = m_crosses[piece] + m_crosses[i];
        const double length = glm::length(sum);
        return std::ranges::all_of(m_pieces[i].faces, [&](std::uint32_t face) {
            const glm::dvec3& cross = m_surface.cross(face);
            return glm::dot(cross, sum) > facingOfSpecks * glm::length(cross) * length;
        });
    }

    const PlacedSurface& m_surface;
    std::vector<Piece> m_pieces;
    std::vector<double> m_areas;
    std::vector<glm::dvec3> m_crosses;  ///< the mean normal's direction
    std::vector<std::size_t> m_pieceOf;
};

}  // namespace

std::vector<Piece> chartPieces(const PlacedSurface& surface) {
    const std::vector<std::uint32_t> groups = GroupChoice(surface).choose();
    std::vector<std::uint32_t> faces;
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face)
        if (surface.area(face) > 0) faces.push_back(face);
    std::vector<Piece> pieces;
    for (auto& part : FaceConnector(surface).parts(
             faces, [&](std::uint32_t a, std::uint32_t b) { return groups[a] == groups[b]; })) {
        const std::uint32_t group = groups[part.front()];
        pieces.push_back({std::move(part), group});
    }
    return SpeckJoiner(surface, std::move(pieces)).join();
}

}  // namespace chiaro::exporting
