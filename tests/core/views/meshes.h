#pragma once

#include "core/views/surface.h"
#include "tests/core/scene/shapes.h"

#include <memory>
#include <string>
#include <vector>

namespace chiaro::test {

/// A box with corners at -half and half around a centre, faces outwards or, turned inside out, inwards.
inline scene::Mesh box(glm::vec3 center, glm::vec3 half, bool outwards = true) {
    scene::Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.positions.push_back(center + half * glm::vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 4, 6}, {0, 6, 2},
                      {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3}};
    if (!outwards)
        for (scene::Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    mesh.normals.assign(8, {0, 0, 1});
    return mesh;
}

/// The square quad() moved and scaled; faces +Z.
inline scene::Mesh square(float z, float half = 1, glm::vec2 center = {0, 0}) {
    scene::Mesh mesh = quad();
    for (glm::vec3& position : mesh.positions) position = glm::vec3(glm::vec2(position) * half + center, z);
    return mesh;
}

/// One triangle.
inline scene::Mesh triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    scene::Mesh mesh;
    mesh.positions = {a, b, c};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

inline scene::Mesh scaled(scene::Mesh mesh, float factor) {
    for (glm::vec3& position : mesh.positions) position *= factor;
    return mesh;
}

inline views::Surface surfaceOf(const std::vector<scene::Mesh>& meshes) {
    return views::Surface(std::make_shared<const scene::Mesh>(scene::merged(meshes)));
}

/// A mesh that is unusual in one way, and what that is.
struct OddMesh {
    std::string what;
    std::vector<scene::Mesh> parts;
};

/// Small meshes of every kind of trouble that visibility may have.
inline std::vector<OddMesh> oddMeshes() {
    scene::Mesh slivers = square(0);
    slivers.positions.insert(slivers.positions.end(),
                             {{0.5f, 0, 0.1f}, {0.5f, 0.5f, 0.1f}, {0.500001f, 0.2f, 0.1f}});
    slivers.normals.assign(slivers.positions.size(), {0, 0, 1});
    slivers.triangles.push_back({4, 5, 6});
    slivers.triangles.push_back({4, 5, 5});
    slivers.triangles.push_back({4, 4, 4});
    scene::Mesh standing = square(0);  // pierces the square z = 0
    for (glm::vec3& position : standing.positions) position = {position.z, position.y, position.x};
    scene::Mesh pins = square(0);  // far smaller than a texel, over a large square
    for (int i = 0; i < 20; ++i) {
        const scene::Mesh pin = box({0.09f * float(i) - 0.85f, 0.31f, 0.2f}, glm::vec3(2e-4f));
        pins = scene::merged({pins, pin});
    }
    return {{"a triangle", {triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})}},
            {"a plane", {square(0)}},
            {"a box", {box({0, 0, 0}, glm::vec3(1))}},
            {"a box inside out", {box({0, 0, 0}, glm::vec3(1), false)}},
            {"a box in a box", {box({0, 0, 0}, glm::vec3(1)), box({0.1f, 0, 0}, glm::vec3(0.5f))}},
            {"a room with a box", {box({0, 0, 0}, glm::vec3(1), false), box({0.1f, 0, 0}, glm::vec3(0.5f))}},
            {"three boxes inside each other, the middle one inside out",
             {box({0, 0, 0}, glm::vec3(1)), box({0, 0, 0}, glm::vec3(0.8f), false),
              box({0, 0, 0}, glm::vec3(0.5f))}},
            {"the same square twice", {square(0), square(0)}},
            {"coincident squares, cut differently", {square(0), square(0, 0.5f, {0.2f, 0.1f})}},
            {"squares that pierce each other", {square(0), standing}},
            {"a stack of squares", {square(0), square(0.1f), square(0.2f), square(0.3f), square(0.4f)}},
            {"slivers and faces without area", {slivers}},
            {"pins", {pins}},
            {"two balls that touch", {ball(16, 8), scaled(ball(10, 6), 0.5f)}}};
}

}  // namespace chiaro::test
