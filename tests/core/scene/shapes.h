#pragma once

#include "core/scene/mesh.h"
#include "core/scene/scene.h"

#include <memory>

namespace chiaro::test {

/// A square of side 2 in the plane z = 0 around the origin, facing +Z: corners (-1,-1), (1,-1), (1,1),
/// (-1,1).
inline scene::Mesh quad() {
    scene::Mesh mesh;
    mesh.name = "quad";
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// A ball of radius 1 around the origin from 2 * slices * (stacks - 1) triangles, with smooth normals.
inline scene::Mesh ball(int slices, int stacks) {
    scene::Mesh mesh;
    mesh.name = "ball";
    for (int j = 0; j <= stacks; ++j)
        for (int i = 0; i < slices; ++i) {
            const double theta = M_PI * j / stacks;
            const double phi = 2 * M_PI * i / slices;
            mesh.positions.emplace_back(std::sin(theta) * std::sin(phi), std::cos(theta),
                                        std::sin(theta) * std::cos(phi));
        }
    mesh.normals = mesh.positions;
    const auto at = [&](int i, int j) { return std::uint32_t(j * slices + i % slices); };
    for (int j = 0; j < stacks; ++j)
        for (int i = 0; i < slices; ++i) {
            if (j > 0) mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            if (j + 1 < stacks) mesh.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    return mesh;
}

inline scene::Scene sceneOf(std::vector<scene::Mesh> meshes) {
    scene::Scene scene;
    for (scene::Mesh& mesh : meshes)
        scene.objects.push_back(
            {mesh.name, std::make_shared<const scene::Mesh>(std::move(mesh)), glm::mat4(1), 0, true});
    return scene;
}

/// Looks from +Z at the origin; the unit ball just fills the picture.
inline scene::Camera frontCamera() {
    scene::Camera camera;
    camera.azimuth = 0;
    camera.elevation = 0;
    return camera;
}

}  // namespace chiaro::test
