#include "core/export/flat_faces.h"

#include <algorithm>
#include <cmath>

namespace chiaro::exporting {

namespace {

/// Of the faces' reach: far above what the arithmetic rounds, far below a texel of any atlas.
constexpr double relativeTolerance = 1e-7;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

}  // namespace

FlatFaces::FlatFaces(const glm::dvec2& low, const glm::dvec2& high, std::size_t count) : m_low(low) {
    const glm::dvec2 extent = glm::max(high - low, glm::dvec2(1e-300));
    const double longest = std::max(extent.x, extent.y);
    m_tolerance = relativeTolerance * longest;
    const double most = std::max(std::sqrt(double(count)), 1.0);
    m_cell = std::max(std::sqrt(extent.x * extent.y / double(std::max<std::size_t>(count, 1))),
                      longest / (4 * most));
    m_cells = glm::ivec2(extent / m_cell) + 1;
    m_facesOfCells.resize(std::size_t(m_cells.x) * std::size_t(m_cells.y));
}

template <class Visit>
bool FlatFaces::anyCell(const FlatFace& face, Visit visit) {
    const auto cellOf = [this](const glm::dvec2& point) {
        return glm::clamp(glm::ivec2((point - m_low) / m_cell), glm::ivec2(0), m_cells - 1);
    };
    const glm::ivec2 low = cellOf(glm::min(glm::min(face[0], face[1]), face[2]));
    const glm::ivec2 high = cellOf(glm::max(glm::max(face[0], face[1]), face[2]));
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x)
            if (visit(m_facesOfCells[std::size_t(y) * std::size_t(m_cells.x) + std::size_t(x)])) return true;
    return false;
}

bool FlatFaces::add(const FlatFace& face) {
    const auto overlapsOne = [&](const std::vector<std::uint32_t>& faces) {
        return std::ranges::any_of(faces, [&](std::uint32_t other) { return overlap(face, m_faces[other]); });
    };
    if (anyCell(face, overlapsOne)) return false;
    const auto number = std::uint32_t(m_faces.size());
    m_faces.push_back(face);
    anyCell(face, [number](std::vector<std::uint32_t>& faces) {
        faces.push_back(number);
        return false;
    });
    return true;
}

bool FlatFaces::overlap(const FlatFace& a, const FlatFace& b) const {
    return !separates(a, b) && !separates(b, a);
}

/// Whether all of b lies beyond one of a's edges.
bool FlatFaces::separates(const FlatFace& a, const FlatFace& b) const {
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 edge = a[(k + 1) % 3] - a[k];
        const double least = m_tolerance * glm::length(edge);
        const auto isBeyond = [&](const glm::dvec2& point) { return cross(edge, point - a[k]) <= least; };
        if (std::ranges::all_of(b, isBeyond)) return true;
    }
    return false;
}

}  // namespace chiaro::exporting
