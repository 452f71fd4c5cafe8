// Angle-weighted normals (Thürmer and Wüthrich 1998): each face counts by its angle at the vertex, so the
// result does not depend on how a surface was cut into triangles.

#include "core/scene/mesh.h"
#include "core/scene/mesh_edges.h"
#include "core/scene/mesh_tasks.h"

#include <tbb/parallel_sort.h>

#include <algorithm>

namespace chiaro::scene {

namespace {

constexpr std::size_t checkedFaces = 65536;  ///< between two checkpoints

/// A face's unit normal (zero without area) and its angles at the three corners. In double, so that very
/// small and very large meshes neither underflow nor overflow.
struct FaceShape {
    glm::dvec3 normal{0};
    glm::dvec3 angles{0};
};

FaceShape shapeOf(const Mesh& mesh, const Triangle& triangle) {
    const glm::dvec3 a(mesh.positions[triangle[0]]);
    const glm::dvec3 b(mesh.positions[triangle[1]]);
    const glm::dvec3 c(mesh.positions[triangle[2]]);
    FaceShape shape;
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double area = glm::length(cross);
    if (!(area > 0)) return shape;
    shape.normal = cross / area;
    // |cross| is the same at each corner: twice the area.
    shape.angles = {std::atan2(area, glm::dot(b - a, c - a)), std::atan2(area, glm::dot(c - b, a - b)),
                    std::atan2(area, glm::dot(a - c, b - c))};
    return shape;
}

glm::vec3 unitOr(glm::dvec3 vector, glm::vec3 otherwise) {
    const double length = glm::length(vector);
    return length > 1e-9 ? glm::vec3(vector / length) : otherwise;
}

/// 1 for faces that have the same three corners in space as an earlier one.
std::vector<std::uint8_t> repeatedFaces(const Mesh& mesh, const std::vector<std::uint32_t>& welded) {
    std::vector<std::array<std::uint32_t, 4>> keys;  // the corners, sorted, and the face
    keys.reserve(mesh.triangles.size());
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
        const Triangle& triangle = mesh.triangles[f];
        keys.push_back({welded[triangle[0]], welded[triangle[1]], welded[triangle[2]], f});
        std::sort(keys.back().begin(), keys.back().begin() + 3);
    }
    tbb::parallel_sort(keys.begin(), keys.end());
    std::vector<std::uint8_t> repeated(keys.size(), 0);
    for (std::size_t i = 1; i < keys.size(); ++i)
        repeated[keys[i][3]] = std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin());
    return repeated;
}

/// Sets over the numbers 0..count-1 that can be united (path halving).
class DisjointSets {
public:
    explicit DisjointSets(std::uint32_t count) {
        m_parent.reserve(count);
        for (std::uint32_t i = 0; i < count; ++i) m_parent.push_back(i);
    }
    std::uint32_t find(std::uint32_t i) {
        while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    /// The smaller root wins, so roots do not depend on the order.
    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        m_parent[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> m_parent;
};

std::uint32_t cornerAt(const Mesh& mesh, const std::vector<std::uint32_t>& welded, std::uint32_t face,
                       std::uint32_t vertex) {
    for (std::uint32_t k = 0; k < 2; ++k)
        if (welded[mesh.triangles[face][k]] == vertex) return face * 3 + k;
    return face * 3 + 2;
}

}  // namespace

std::vector<glm::vec3> angleWeightedNormals(const Mesh& mesh) {
    return angleWeightedNormals(mesh, {});
}

std::vector<glm::vec3> angleWeightedNormals(const Mesh& mesh, const Task& task) {
    const std::vector<std::uint32_t> welded = weldedIndices(mesh);
    task.checkpoint();
    const std::vector<std::uint8_t> repeated = repeatedFaces(mesh, welded);
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0));
    // Where the sum cancels (a sheet folded back, faces that disagree about the front), the first face
    // decides.
    std::vector<glm::vec3> first(mesh.positions.size(), glm::vec3(0));
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        if (f % checkedFaces == 0) task.checkpoint();
        if (repeated[f]) continue;
        const FaceShape shape = shapeOf(mesh, mesh.triangles[f]);
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t vertex = welded[mesh.triangles[f][std::size_t(k)]];
            sums[vertex] += shape.normal * shape.angles[k];
            if (first[vertex] == glm::vec3(0)) first[vertex] = glm::vec3(shape.normal);
        }
    }
    std::vector<glm::vec3> normals(mesh.positions.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const glm::vec3 fallback = first[welded[i]] == glm::vec3(0) ? glm::vec3(0, 0, 1) : first[welded[i]];
        normals[i] = unitOr(sums[welded[i]], fallback);
    }
    return normals;
}

Mesh splitAtCreases(const Mesh& mesh, float creaseDegrees) {
    return splitAtCreases(mesh, creaseDegrees, {});
}

Mesh splitAtCreases(const Mesh& mesh, float creaseDegrees, const Task& task) {
    const std::vector<std::uint32_t> welded = weldedIndices(mesh);
    task.checkpoint();
    std::vector<FaceShape> shapes;
    shapes.reserve(mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) shapes.push_back(shapeOf(mesh, triangle));
    task.checkpoint();

    // Corners (3 * face + 0..2) that share a vertex are one where a chain of smooth edges joins their faces.
    DisjointSets corners(std::uint32_t(mesh.triangles.size() * 3));
    const double smooth = std::cos(glm::radians(double(creaseDegrees)));
    forEachEdge(sortedEdges(mesh, welded), [&](std::span<const Edge> faces) {
        if (faces.size() != 2) return;
        if (glm::dot(shapes[faces[0].face].normal, shapes[faces[1].face].normal) < smooth) return;
        for (const std::uint32_t vertex : {faces[0].low, faces[0].high})
            corners.unite(cornerAt(mesh, welded, faces[0].face, vertex),
                          cornerAt(mesh, welded, faces[1].face, vertex));
    });

    task.checkpoint();
    Mesh result;
    result.name = mesh.name;
    result.triangles.resize(mesh.triangles.size());
    std::vector<glm::dvec3> sums;
    std::vector<std::uint32_t> vertexOfCorner(mesh.triangles.size() * 3);
    for (std::uint32_t corner = 0; corner < vertexOfCorner.size(); ++corner) {
        const std::uint32_t root = corners.find(corner);
        if (root == corner) {
            vertexOfCorner[corner] = std::uint32_t(result.positions.size());
            result.positions.push_back(mesh.positions[mesh.triangles[corner / 3][corner % 3]]);
            sums.emplace_back(0);
        }
        const std::uint32_t vertex = vertexOfCorner[corner] = vertexOfCorner[root];
        result.triangles[corner / 3][corner % 3] = vertex;
        const FaceShape& shape = shapes[corner / 3];
        sums[vertex] += shape.normal * shape.angles[int(corner % 3)];
    }
    for (const glm::dvec3& sum : sums) result.normals.push_back(unitOr(sum, glm::vec3(0, 0, 1)));
    return result;
}

}  // namespace chiaro::scene
