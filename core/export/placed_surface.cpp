#include "core/export/placed_surface.h"

#include "core/scene/mesh_edges.h"

#include <algorithm>

namespace chiaro::exporting {

PlacedSurface::PlacedSurface(const PlannedPlace& place)
    : m_planned(*place.planned), m_linear(glm::dmat4(place.transform)) {
    const scene::Mesh& mesh = m_planned.surface.mesh();
    const glm::dmat4 transform(place.transform);
    m_points.reserve(mesh.positions.size());
    for (const glm::vec3& position : mesh.positions)
        m_points.emplace_back(transform * glm::dvec4(glm::dvec3(position), 1));
    // A transform that mirrors turns the corners' sense around, not the side that is the front.
    const double sense = isMirrored() ? -1 : 1;
    m_crosses.resize(faceCount(), glm::dvec3(0));
    for (std::uint32_t face = 0; face < faceCount(); ++face)
        if (m_planned.surface.area(face) > 0)
            m_crosses[face] =
                sense * glm::cross(corner(face, 1) - corner(face, 0), corner(face, 2) - corner(face, 0));
    findNeighbours();
}

glm::dvec3 PlacedSurface::towardsEye(std::size_t group) const {
    return glm::normalize(m_linear * glm::normalize(m_planned.plan.groups[group].view.direction));
}

void PlacedSurface::findNeighbours() {
    const scene::Mesh& mesh = m_planned.surface.mesh();
    const std::vector<scene::Edge> edges = scene::sortedEdges(mesh, scene::weldedIndices(mesh));
    // At an edge of a sheet with a front and a back four faces meet, and only two of them go on into each
    // other; where very many do, each is linked to the next few.
    constexpr std::size_t most = 8;
    const auto eachPair = [&](auto&& visit) {
        scene::forEachEdge(edges, [&](std::span<const scene::Edge> shared) {
            for (std::size_t i = 0; i < shared.size(); ++i)
                for (std::size_t j = i + 1; j < std::min(shared.size(), i + most); ++j) {
                    visit(shared[i].face, shared[j].face);
                    visit(shared[j].face, shared[i].face);
                }
        });
    };
    m_first.assign(faceCount() + 1, 0);
    eachPair([this](std::uint32_t face, std::uint32_t) { ++m_first[face + 1]; });
    for (std::size_t i = 1; i < m_first.size(); ++i) m_first[i] += m_first[i - 1];
    m_neighbours.resize(m_first.back());
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    eachPair([&](std::uint32_t face, std::uint32_t other) { m_neighbours[next[face]++] = other; });
}

}  // namespace chiaro::exporting
