#include "core/methods/view_weights.h"

#include "core/methods/view_map.h"

#include <tbb/parallel_for.h>

#include <queue>

#include <algorithm>

namespace chiaro::methods {

namespace {

/// Along the surface a weight takes this much of the object's radius to rise from a border of its group.
constexpr double featherReach = 0.12;
/// What is left at the border itself, for faces all of whose groups end there.
constexpr float leastFeather = 1e-3f;

/// Which faces meet at each vertex, equal positions being one vertex.
class VertexFaces {
public:
    explicit VertexFaces(const views::Surface& surface)
        : m_welded(scene::weldedIndices(surface.mesh())), m_first(m_welded.size() + 1, 0) {
        const auto& triangles = surface.mesh().triangles;
        const auto eachCorner = [&](auto&& visit) {
            for (std::uint32_t face = 0; face < triangles.size(); ++face)
                if (surface.area(face) > 0)
                    for (const std::uint32_t vertex : triangles[face]) visit(m_welded[vertex], face);
        };
        eachCorner([this](std::uint32_t vertex, std::uint32_t) { ++m_first[vertex + 1]; });
        for (std::size_t i = 1; i < m_first.size(); ++i) m_first[i] += m_first[i - 1];
        m_faces.resize(m_first.back());
        std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
        eachCorner([&](std::uint32_t vertex, std::uint32_t face) { m_faces[next[vertex]++] = face; });
    }

    std::uint32_t welded(std::uint32_t vertex) const { return m_welded[vertex]; }
    std::span<const std::uint32_t> around(std::uint32_t vertex) const {
        return {m_faces.data() + m_first[vertex], m_first[vertex + 1] - m_first[vertex]};
    }
    std::size_t count() const { return m_welded.size(); }

private:
    std::vector<std::uint32_t> m_welded;
    std::vector<std::size_t> m_first;
    std::vector<std::uint32_t> m_faces;
};

/// Along the edges of a group's faces, how far each vertex lies from the group's border; at most `reach`.
std::vector<float> borderDistances(const views::Surface& surface, const VertexFaces& vertices,
                                   const std::vector<bool>& isMember, const std::vector<std::uint32_t>& faces,
                                   float reach) {
    const scene::Mesh& mesh = surface.mesh();
    std::vector<float> distances(vertices.count(), reach);
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (const std::uint32_t face : faces)
        for (const std::uint32_t corner : mesh.triangles[face]) {
            const std::uint32_t vertex = vertices.welded(corner);
            if (distances[vertex] == 0) continue;
            const auto outside = [&](std::uint32_t other) { return !isMember[other]; };
            if (!std::ranges::any_of(vertices.around(vertex), outside)) continue;
            distances[vertex] = 0;
            open.emplace(0.0f, vertex);
        }
    while (!open.empty()) {
        const auto [distance, vertex] = open.top();
        open.pop();
        if (distance > distances[vertex]) continue;
        for (const std::uint32_t face : vertices.around(vertex)) {
            if (!isMember[face]) continue;
            for (const std::uint32_t corner : mesh.triangles[face]) {
                const std::uint32_t next = vertices.welded(corner);
                const float way = distance + glm::distance(mesh.positions[vertex], mesh.positions[corner]);
                if (way >= distances[next]) continue;
                distances[next] = way;
                open.emplace(way, next);
            }
        }
    }
    return distances;
}

/// The corner's own normal, on the face's side.
glm::dvec3 cornerNormal(const views::Surface& surface, std::uint32_t face, std::size_t k) {
    const glm::dvec3 normal(surface.mesh().normals[surface.mesh().triangles[face][k]]);
    return glm::dot(normal, surface.normal(face)) < 0 ? -normal : normal;
}

}  // namespace

ViewWeights::ViewWeights(const PlannedObject& object, double epsilon) {
    const views::Surface& surface = object.surface;
    const auto& groups = object.plan.groups;
    const FaceGroups memberships(object);
    m_first.assign(surface.faceCount() + 1, 0);
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face)
        m_first[face + 1] = m_first[face] + memberships.of(face).size();
    m_views.resize(m_first.back());
    const VertexFaces vertices(surface);
    const auto reach = float(featherReach * surface.radius());
    tbb::parallel_for(std::size_t(0), groups.size(), [&](std::size_t group) {
        const views::Projector projector(groups[group].view);
        std::vector<bool> isMember(surface.faceCount(), false);
        for (const std::uint32_t face : groups[group].faces) isMember[face] = true;
        const std::vector<float> distances =
            borderDistances(surface, vertices, isMember, groups[group].faces, reach);
        for (const std::uint32_t face : groups[group].faces) {
            const auto groupsOfFace = memberships.of(face);
            const auto place = std::ranges::find(groupsOfFace, group, &FaceGroups::Membership::group);
            FaceView& view = m_views[m_first[face] + std::size_t(place - groupsOfFace.begin())];
            view.group = std::uint32_t(group);
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec3 point = surface.corner(face, k);
                const std::uint32_t vertex = vertices.welded(surface.mesh().triangles[face][k]);
                const float feather = glm::smoothstep(0.0f, reach, distances[vertex]);
                view.corners[k] = {glm::vec2(projector.project(point)),
                                   float(projector.alpha(point, cornerNormal(surface, face, k), epsilon)) *
                                       (feather + leastFeather)};
            }
        }
    });
}

}  // namespace chiaro::methods
