#include "core/scene/mesh_winding.h"

#include <utility>

namespace chiaro::scene {

std::vector<Triangle> trianglesTowardsNormals(const Mesh& mesh) {
    std::vector<Triangle> triangles = mesh.triangles;
    for (auto& [a, b, c] : triangles) {
        const glm::vec3 face =
            glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
        if (glm::dot(face, mesh.normals[a] + mesh.normals[b] + mesh.normals[c]) < 0) std::swap(b, c);
    }
    return triangles;
}

}  // namespace chiaro::scene
