#include "core/scene/mesh.h"

#include "tests/core/scene/shapes.h"

#include <gtest/gtest.h>

namespace chiaro::scene {
namespace {

/// A cube from -1 to 1 whose faces share no vertices: 12 triangles, 36 vertices.
Mesh facettedCube() {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            const auto corner = [&](float u, float v) {
                glm::vec3 point;
                point[axis] = side;
                point[(axis + 1) % 3] = side * u;
                point[(axis + 2) % 3] = v;
                return point;
            };
            for (const auto& [u, v] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}) {
                if (mesh.positions.size() % 3 == 0) mesh.triangles.emplace_back();
                mesh.triangles.back()[mesh.positions.size() % 3] = std::uint32_t(mesh.positions.size());
                mesh.positions.push_back(corner(float(u), float(v)));
            }
        }
    return mesh;
}

TEST(Mesh, BoundsCountOnlyVerticesThatFacesUse) {
    Mesh mesh = test::quad();
    mesh.positions.push_back({100, 100, 100});
    EXPECT_EQ(boundsOf(mesh).maximum, glm::vec3(1, 1, 0));
    EXPECT_FLOAT_EQ(boundsOf(mesh).radius, std::sqrt(2.0f));
    EXPECT_EQ(boundsOf(Mesh{}).maximum, glm::vec3(0));
}

TEST(Mesh, EqualPositionsAreWeldedToTheFirst) {
    Mesh mesh;
    mesh.positions = {{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0f, 0, 0}};
    EXPECT_EQ(weldedIndices(mesh), (std::vector<std::uint32_t>{0, 1, 0, 1}));
}

TEST(Normals, CornerOfACubePointsAlongTheDiagonalHoweverItsFacesAreCut) {
    const Mesh cube = facettedCube();
    const std::vector<glm::vec3> normals = angleWeightedNormals(cube);
    for (std::size_t i = 0; i < normals.size(); ++i)
        EXPECT_GT(glm::dot(normals[i], cube.positions[i]) / std::sqrt(3.0f), 0.99999f);
}

TEST(Normals, ASheetWithTwoSidesKeepsTheNormalsOfTheFirst) {
    Mesh sheet = test::quad();
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}};
    for (const glm::vec3& normal : angleWeightedNormals(sheet)) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(Normals, VerticesWithoutAreaPointAlongZ) {
    Mesh line;
    line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    line.triangles = {{0, 1, 2}};
    for (const glm::vec3& normal : angleWeightedNormals(line)) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(Normals, TinyAndHugeMeshesHaveThemToo) {
    for (const float scale : {1e-18f, 1e14f}) {
        Mesh mesh = test::quad();
        for (glm::vec3& position : mesh.positions) position *= scale;
        for (const glm::vec3& normal : angleWeightedNormals(mesh)) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    }
}

TEST(Creases, ACubeKeepsItsEdgesAndWeldsItsFaces) {
    const Mesh cube = facettedCube();
    const Mesh split = splitAtCreases(cube, 40);
    EXPECT_EQ(split.positions.size(), 24u);
    ASSERT_EQ(split.triangles.size(), cube.triangles.size());
    for (std::size_t f = 0; f < 12; ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = split.triangles[f][k];
            EXPECT_EQ(split.positions[vertex], cube.positions[cube.triangles[f][k]]);
            const glm::vec3 normal = split.normals[vertex];
            EXPECT_NEAR(std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}), 1, 1e-6);
            EXPECT_NEAR(glm::dot(normal, split.positions[vertex]), 1, 1e-6);
        }
}

TEST(Creases, ABallStaysSmooth) {
    Mesh facets;
    const Mesh ball = test::ball(32, 16);
    for (const Triangle& triangle : ball.triangles) {
        const auto base = std::uint32_t(facets.positions.size());
        for (const std::uint32_t vertex : triangle) facets.positions.push_back(ball.positions[vertex]);
        facets.triangles.push_back({base, base + 1, base + 2});
    }
    const Mesh smooth = splitAtCreases(facets, 40);
    for (std::size_t i = 0; i < smooth.positions.size(); ++i)
        EXPECT_GT(glm::dot(smooth.normals[i], smooth.positions[i]), 0.99f);
    EXPECT_LT(smooth.positions.size(), 32u * 17u);
}

TEST(Topology, CountsOpenAndCrowdedEdgesAndFacesWithoutArea) {
    EXPECT_EQ(topologyOf(test::quad()).boundaryEdges, 4u);
    EXPECT_EQ(topologyOf(facettedCube()).boundaryEdges, 0u);
    Mesh fin = test::quad();  // a third face at the diagonal
    fin.positions.push_back({0, 0, 1});
    fin.triangles.push_back({0, 2, 4});
    EXPECT_EQ(topologyOf(fin).nonManifoldEdges, 1u);
    EXPECT_EQ(topologyOf(fin).boundaryEdges, 6u);
    fin.triangles.push_back({1, 1, 3});
    EXPECT_EQ(topologyOf(fin).degenerateFaces, 1u);
    EXPECT_EQ(topologyOf(fin).boundaryEdges, 6u);
}

}  // namespace
}  // namespace chiaro::scene
