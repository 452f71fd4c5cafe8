#include "core/scene/mesh_edges.h"

#include "core/scene/mesh_tasks.h"

#include <tbb/parallel_sort.h>

namespace chiaro::scene {

std::vector<Edge> sortedEdges(const Mesh& mesh, const std::vector<std::uint32_t>& welded) {
    std::vector<Edge> edges;
    edges.reserve(mesh.triangles.size() * 3);
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
        const Triangle& triangle = mesh.triangles[f];
        const Triangle ends{welded[triangle[0]], welded[triangle[1]], welded[triangle[2]]};
        if (ends[0] == ends[1] || ends[1] == ends[2] || ends[2] == ends[0]) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(ends[k], ends[(k + 1) % 3]);
            edges.push_back({low, high, f});
        }
    }
    tbb::parallel_sort(edges.begin(), edges.end());
    return edges;
}

Topology topologyOf(const Mesh& mesh) {
    return topologyOf(mesh, {});
}

Topology topologyOf(const Mesh& mesh, const Task& task) {
    Topology topology;
    for (const Triangle& triangle : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[triangle[0]]);
        const glm::dvec3 normal = glm::cross(glm::dvec3(mesh.positions[triangle[1]]) - a,
                                             glm::dvec3(mesh.positions[triangle[2]]) - a);
        if (normal == glm::dvec3(0)) ++topology.degenerateFaces;
    }
    task.checkpoint();
    const std::vector<Edge> edges = sortedEdges(mesh, weldedIndices(mesh));
    task.checkpoint();
    forEachEdge(edges, [&](std::span<const Edge> faces) {
        if (faces.size() == 1) ++topology.boundaryEdges;
        if (faces.size() > 2) ++topology.nonManifoldEdges;
    });
    return topology;
}

}  // namespace chiaro::scene
