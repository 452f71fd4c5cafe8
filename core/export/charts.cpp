#include "core/export/charts.h"

#include "core/export/chart_pieces.h"

#include <algorithm>

namespace chiaro::exporting {

namespace {

/// Charts are turned to a smaller box only when that saves this much of it: upright ones are easier to read.
constexpr double worthTurning = 0.9;
constexpr int turns = 24;

/// Flattens along a direction.
struct Plane {
    glm::dvec3 right, up;
    /// What stands upright in the scene stands upright in the chart.
    explicit Plane(const glm::dvec3& direction) {
        const glm::dvec3 sideways = glm::cross(glm::dvec3(0, 1, 0), direction);
        const bool isFlat = glm::length(sideways) < 1e-3;
        right = glm::normalize(isFlat ? glm::cross(glm::dvec3(0, 0, -1), direction) : sideways);
        up = glm::cross(direction, right);
    }
    glm::dvec2 operator()(const glm::dvec3& point) const {
        return {glm::dot(right, point), glm::dot(up, point)};
    }
};

class ChartMaker {
public:
    ChartMaker(const PlacedSurface& surface, std::size_t object)
        : m_surface(surface), m_object(object), m_isOpen(surface.faceCount(), false) {}

    std::vector<Chart> make(const Task& task) {
        for (Piece& piece : chartPieces(m_surface)) layFlat(std::move(piece), task);
        return std::move(m_charts);
    }

private:
    using Faces = std::vector<std::uint32_t>;

    /// As one chart, and what doesn't fit into it as further ones.
    void layFlat(Piece piece, const Task& task) {
        std::vector<Faces> open{std::move(piece.faces)};
        while (!open.empty()) {
            task.checkpoint();
            const Faces faces = std::move(open.back());
            open.pop_back();
            const Faces rest = addChart(faces, direction(faces, piece.group));
            for (Faces& next : m_connector.parts(rest, [](auto, auto) { return true; }))
                open.push_back(std::move(next));
        }
    }

    bool isSeen(std::uint32_t face, const glm::dvec3& direction) const {
        const glm::dvec3& cross = m_surface.cross(face);
        return glm::dot(cross, direction) > leastFacing * glm::length(cross);
    }

    /// From where most of the area is seen well.
    glm::dvec3 direction(const Faces& faces, std::uint32_t group) const {
        glm::dvec3 sum(0);
        for (const std::uint32_t face : faces) sum += m_surface.cross(face);
        glm::dvec3 best = glm::normalize(m_surface.cross(faces.front()));
        double most = 0;
        const auto consider = [&](const glm::dvec3& candidate) {
            double seen = 0;
            for (const std::uint32_t face : faces)
                if (isSeen(face, candidate)) seen += m_surface.area(face);
            if (seen <= most) return;
            most = seen;
            best = candidate;
        };
        if (glm::length(sum) > 0) consider(glm::normalize(sum));
        if (group != noGroup) consider(m_surface.towardsEye(group));
        consider(glm::normalize(m_surface.cross(faces.front())));
        return best;
    }

    /// Lays down the first face that is seen and what can be reached from it without overlapping; returns the
    /// others.
    Faces addChart(const Faces& faces, const glm::dvec3& direction) {
        const Plane plane(direction);
        const auto flat = [&](std::uint32_t face) {
            return FlatFace{plane(m_surface.corner(face, 0)), plane(m_surface.corner(face, 1)),
                            plane(m_surface.corner(face, 2))};
        };
        glm::dvec2 low(std::numeric_limits<double>::max()), high(-low);
        for (const std::uint32_t face : faces) {
            m_isOpen[face] = true;
            for (const glm::dvec2& corner : flat(face)) {
                low = glm::min(low, corner);
                high = glm::max(high, corner);
            }
        }
        FlatFaces laid(low, high, faces.size());
        Chart chart{m_object, {}, {}, {}};
        const auto lay = [&](std::uint32_t face) {
            if (!m_isOpen[face] || !isSeen(face, direction)) return;
            FlatFace corners = flat(face);
            if (m_isMirrored) std::swap(corners[1], corners[2]);
            if (!laid.add(corners)) return;
            if (m_isMirrored) std::swap(corners[1], corners[2]);
            m_isOpen[face] = false;
            chart.faces.push_back(face);
            chart.corners.push_back(corners);
        };
        lay(*std::ranges::find_if(faces, [&](std::uint32_t face) { return isSeen(face, direction); }));
        for (std::size_t i = 0; i < chart.faces.size(); ++i)
            for (const std::uint32_t other : m_surface.neighbours(chart.faces[i])) lay(other);
        Faces rest;
        for (const std::uint32_t face : faces) {
            if (m_isOpen[face]) rest.push_back(face);
            m_isOpen[face] = false;
        }
        finish(chart);
        m_charts.push_back(std::move(chart));
        return rest;
    }

    /// As large as its surface, turned so that it takes little room, and moved to the origin.
    void finish(Chart& chart) const {
        double surface = 0, flat = 0;
        for (std::size_t i = 0; i < chart.faces.size(); ++i) {
            const FlatFace& face = chart.corners[i];
            const glm::dvec2 a = face[1] - face[0], b = face[2] - face[0];
            surface += m_surface.area(chart.faces[i]);
            flat += std::abs(a.x * b.y - a.y * b.x) / 2;
        }
        const double scale = std::sqrt(surface / flat);
        double best = 0;
        double angle = 0;
        for (int turn = 0; turn < turns; ++turn) {
            const double candidate = glm::radians(turn * 90.0 / turns);
            const auto [low, high] = boxOf(chart, turned(candidate));
            const double area = (high.x - low.x) * (high.y - low.y);
            if (turn != 0 && area >= best * (angle == 0 ? worthTurning : 1)) continue;
            best = area;
            angle = candidate;
        }
        const glm::dmat2 turn = turned(angle);
        const auto [low, high] = boxOf(chart, turn);
        for (FlatFace& face : chart.corners)
            for (glm::dvec2& corner : face) {
                const glm::dvec2 moved = turn * corner;
                corner = glm::dvec2(moved.x - low.x, high.y - moved.y) * scale;
            }
        chart.size = (high - low) * scale;
    }

    static glm::dmat2 turned(double angle) {
        return {std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle)};
    }

    static std::pair<glm::dvec2, glm::dvec2> boxOf(const Chart& chart, const glm::dmat2& turn) {
        glm::dvec2 low(std::numeric_limits<double>::max()), high(-low);
        for (const FlatFace& face : chart.corners)
            for (const glm::dvec2& corner : face) {
                const glm::dvec2 moved = turn * corner;
                low = glm::min(low, moved);
                high = glm::max(high, moved);
            }
        return {low, high};
    }

    const PlacedSurface& m_surface;
    std::size_t m_object;
    bool m_isMirrored = m_surface.isMirrored();
    FaceConnector m_connector{m_surface};
    std::vector<bool> m_isOpen;  ///< in the piece that is laid flat, and not yet in a chart
    std::vector<Chart> m_charts;
};

}  // namespace

std::vector<Chart> makeCharts(const PlacedSurface& surface, std::size_t object, const Task& task) {
    return ChartMaker(surface, object).make(task);
}

}  // namespace chiaro::exporting
