#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace chiaro::scene {

using Triangle = std::array<std::uint32_t, 3>;

/// An indexed triangle list: the truth about a mesh, whatever its topology (open, disconnected,
/// non-manifold).
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;  ///< finite
    std::vector<glm::vec3> normals;    ///< one a position, unit length; split vertices keep creases
    std::vector<Triangle>
        triangles;  ///< counter-clockwise seen from the front; indices below positions.size()
};

struct Bounds {
    glm::vec3 minimum{0};
    glm::vec3 maximum{0};
    float radius = 0;  ///< of the smallest sphere around center() that holds every vertex
    glm::vec3 center() const { return minimum * 0.5f + maximum * 0.5f; }
};

/// Gathers the bounds of several meshes at their places.
class BoundsBuilder {
public:
    /// Adds the vertices that triangles use.
    void addMesh(const Mesh& mesh, const glm::mat4& transform);
    /// Zero bounds when nothing was added.
    Bounds bounds() const;

private:
    void addPoint(glm::vec3 point);
    Bounds m_bounds;
    std::vector<glm::vec3> m_points;
};

/// Bounds of the vertices that triangles use. Throws nothing; an empty mesh has zero bounds.
Bounds boundsOf(const Mesh& mesh);

/// All as one nameless mesh, vertices and triangles in order; normals too if every mesh has them.
Mesh merged(const std::vector<Mesh>& meshes);

/// For each position the smallest index of a position equal to it: vertices that are one in space.
std::vector<std::uint32_t> weldedIndices(const Mesh& mesh);

/// Angle-weighted vertex normals over welded positions. Coincident faces count once, so that a sheet modelled
/// with a front and a back keeps the normals of its first side. Vertices of zero-area faces only get
/// (0, 0, 1).
std::vector<glm::vec3> angleWeightedNormals(const Mesh& mesh);

/// The mesh with angle-weighted normals that are smooth except across edges where two faces meet at more than
/// `creaseDegrees` and across edges of more than two faces; vertices are welded, then split along those.
/// Triangles keep their order and corners. For files that know faces but no shared vertices.
Mesh splitAtCreases(const Mesh& mesh, float creaseDegrees);

/// What of a mesh is unusual, after welding equal positions.
struct Topology {
    std::size_t degenerateFaces = 0;   ///< without area
    std::size_t nonManifoldEdges = 0;  ///< edges of more than two faces
    std::size_t boundaryEdges = 0;     ///< edges of one face
};
Topology topologyOf(const Mesh& mesh);

}  // namespace chiaro::scene
