#pragma once

#include "core/scene/mesh.h"

#include <span>

namespace chiaro::scene {

/// An edge of a face, its ends being welded vertices. A sorted list of them answers every question of
/// adjacency that meshes of any topology raise, the third face at an edge included.
struct Edge {
    std::uint32_t low = 0;
    std::uint32_t high = 0;  ///< low < high
    std::uint32_t face = 0;
    friend auto operator<=>(const Edge&, const Edge&) = default;
};

/// All edges of all faces, sorted. Faces with two equal corners have none.
std::vector<Edge> sortedEdges(const Mesh& mesh, const std::vector<std::uint32_t>& welded);

/// Calls visit(std::span<const Edge>) for each edge with the faces that share it, in ascending order.
template <class Visit>
void forEachEdge(const std::vector<Edge>& edges, Visit visit) {
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        while (end < edges.size() && edges[end].low == edges[begin].low &&
               edges[end].high == edges[begin].high)
            ++end;
        visit(std::span(edges).subspan(begin, end - begin));
    }
}

}  // namespace chiaro::scene
