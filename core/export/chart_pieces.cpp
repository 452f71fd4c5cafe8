#include "core/export/chart_pieces.h"

#include "core/methods/view_map.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace chiaro::exporting {

namespace {

constexpr int smoothingRounds = 4;
/// A face may go with its neighbours to a view that sees it at least this well, compared with its best one.
constexpr double goodEnough = 0.75;
/// Pieces with less of the object's area than this are specks.
constexpr double speck = 2e-3;
/// How well a view must face every face of a speck that goes with its surroundings.
constexpr double facingOfSpecks = 0.35;

class GroupChoice {
public:
    explicit GroupChoice(const PlacedSurface& surface)
        : m_surface(surface), m_memberships(surface.planned()), m_groups(surface.faceCount(), noGroup) {
        for (std::size_t i = 0; i < surface.planned().plan.groups.size(); ++i)
            m_directions.push_back(surface.towardsEye(i));
    }

    std::vector<std::uint32_t> choose() {
        for (std::uint32_t face = 0; face < m_groups.size(); ++face) {
            const auto groups = m_memberships.of(face);
            const auto best = std::ranges::max_element(groups, {}, &methods::FaceGroups::Membership::facing);
            if (best != groups.end()) m_groups[face] = best->group;
        }
        for (int round = 0; round < smoothingRounds; ++round) smooth();
        joinSpecks();
        return std::move(m_groups);
    }

private:
    void smooth() {
        for (std::uint32_t face = 0; face < m_groups.size(); ++face) {
            const auto neighbours = m_surface.neighbours(face);
            const auto like = [&](std::uint32_t group) {
                return std::ranges::count_if(neighbours,
                                             [&](auto other) { return m_groups[other] == group; });
            };
            float best = 0;
            for (const auto& membership : m_memberships.of(face)) best = std::max(best, membership.facing);
            auto most = like(m_groups[face]);
            for (const auto& membership : m_memberships.of(face)) {
                if (double(membership.facing) < goodEnough * double(best)) continue;
                const auto count = like(membership.group);
                if (count <= most) continue;
                most = count;
                m_groups[face] = membership.group;
            }
        }
    }

    void joinSpecks() {
        std::vector<std::uint32_t> faces(m_groups.size());
        std::iota(faces.begin(), faces.end(), 0u);
        const auto areaOf = [&](const Piece& piece) {
            return std::accumulate(piece.begin(), piece.end(), 0.0, [&](double sum, std::uint32_t face) {
                return sum + m_surface.area(face);
            });
        };
        const double total = areaOf(faces);
        std::vector<std::pair<double, Piece>> specks;
        for (Piece& piece : connectedPieces(m_surface, faces, [this](std::uint32_t a, std::uint32_t b) {
                 return m_groups[a] == m_groups[b];
             })) {
            const double area = areaOf(piece);
            if (area < speck * total) specks.emplace_back(area, std::move(piece));
        }
        std::ranges::stable_sort(specks, {}, &std::pair<double, Piece>::first);
        for (const auto& [area, piece] : specks) join(piece);
    }

    /// Gives a speck to the group that most of its border touches, if that group's view faces it.
    void join(const Piece& piece) {
        std::map<std::uint32_t, int> touching;
        for (const std::uint32_t face : piece)
            for (const std::uint32_t other : m_surface.neighbours(face))
                if (m_groups[other] != m_groups[face] && m_groups[other] != noGroup)
                    ++touching[m_groups[other]];
        std::uint32_t chosen = noGroup;
        int most = 0;
        for (const auto& [group, count] : touching) {
            if (count <= most || !faces(group, piece)) continue;
            chosen = group;
            most = count;
        }
        if (chosen == noGroup) return;
        for (const std::uint32_t face : piece) m_groups[face] = chosen;
    }

    bool faces(std::uint32_t group, const Piece& piece) const {
        return std::ranges::all_of(piece, [&](std::uint32_t face) {
            const glm::dvec3& cross = m_surface.cross(face);
            return glm::dot(cross, m_directions[group]) > facingOfSpecks * glm::length(cross);
        });
    }

    const PlacedSurface& m_surface;
    const methods::FaceGroups m_memberships;
    std::vector<glm::dvec3> m_directions;
    std::vector<std::uint32_t> m_groups;
};

}  // namespace

std::vector<std::uint32_t> chartGroups(const PlacedSurface& surface) {
    return GroupChoice(surface).choose();
}

std::vector<Piece> connectedPieces(const PlacedSurface& surface, const std::vector<std::uint32_t>& faces,
                                   const std::function<bool(std::uint32_t, std::uint32_t)>& alike) {
    std::vector<bool> isOpen(surface.faceCount(), false);
    for (const std::uint32_t face : faces) isOpen[face] = surface.area(face) > 0;
    std::vector<Piece> pieces;
    for (const std::uint32_t first : faces) {
        if (!isOpen[first]) continue;
        isOpen[first] = false;
        Piece piece{first};
        for (std::size_t i = 0; i < piece.size(); ++i)
            for (const std::uint32_t other : surface.neighbours(piece[i])) {
                if (!isOpen[other] || !alike(piece[i], other)) continue;
                isOpen[other] = false;
                piece.push_back(other);
            }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

}  // namespace chiaro::exporting
