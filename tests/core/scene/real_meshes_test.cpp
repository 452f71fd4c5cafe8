// Meshes and broken files from other people; see the support header on where they are looked for.

#include "core/base/error.h"
#include "core/scene/gbuffer.h"
#include "core/scene/mesh_io.h"
#include "tests/core/scene/shapes.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <set>

namespace chiaro::scene {
namespace {

namespace fs = std::filesystem;

/// Counts published with the files; triangles follow from their polygons.
struct Expected {
    std::size_t objects, faces, boundaryEdges, nonManifoldEdges;
};
const std::map<std::string, Expected> expectations{
    {"skull.obj", {1, 100002, 0, 0}},
    {"skull_low_resolution.obj", {1, 10312, 0, 0}},
    {"spot_control_mesh.obj", {1, 4 + 2 * 160 + 3 * 16, 0, 0}},
    {"suzanne.ply", {1, 32 + 2 * 468, 42, 0}},
    {"teapot.stl", {1, 894, 64, 0}},
    {"cycloidal.ply", {1, 43368, 0, 242}},
    {"plane_holes.obj", {1, 16747, 341, 0}},
    {"cube_no_bottom.obj", {1, 40, 8, 0}},
    {"joined_tetrahedra.obj", {2, 8, 0, 3}},
    {"non_manifold_wrap.obj", {1, 12, 8, 1}},
    {"rabbit.obj", {9, 176 + 2 * 496 + 14 * 6, 0, 0}},
    {"groups.obj", {15, 2308, 0, 0}},          // 14 groups and, after them, an object
    {"chair_model.obj", {4, 12756, 0, 9518}},  // 16 of its 20 objects have no faces
    {"fandisk_quads.off", {1, 2 * 764, 0, 0}},
    {"tet.ply", {1, 4, 0, 0}},
    {"nested.glb", {3, 36, 0, 0}},
    {"simple_pole.glb", {11, 580, 0, 0}},
    {"negative_indices.obj", {1, 12, 0, 0}},
    {"large_22_objects.ply", {1, 501057, 541, 242}},
};

void expectValid(const Model& model) {
    std::size_t faces = 0;
    std::set<std::string> names;
    for (const Mesh& mesh : model.meshes) {
        faces += mesh.triangles.size();
        EXPECT_FALSE(mesh.triangles.empty());
        EXPECT_TRUE(names.insert(mesh.name).second) << mesh.name;
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
        for (const glm::vec3& position : mesh.positions)
            ASSERT_TRUE(std::isfinite(position.x + position.y + position.z));
        for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1, 1e-4);
        for (const Triangle& triangle : mesh.triangles)
            for (const std::uint32_t vertex : triangle) ASSERT_LT(vertex, mesh.positions.size());
    }
    EXPECT_EQ(faces, model.faces);
}

TEST(RealMeshes, LoadWithTheirPublishedCounts) {
    CHIARO_NEEDS_SHARED_DATA();
    for (const auto& [name, expected] : expectations) {
        SCOPED_TRACE(name);
        const Model model = readModel(test::sharedData() / "meshes" / name);
        expectValid(model);
        EXPECT_EQ(model.meshes.size(), expected.objects);
        EXPECT_EQ(model.faces, expected.faces);
        EXPECT_EQ(model.boundaryEdges, expected.boundaryEdges);
        EXPECT_EQ(model.nonManifoldEdges, expected.nonManifoldEdges);
    }
}

TEST(RealMeshes, AnUnusualPathIsNoObstacle) {
    CHIARO_NEEDS_SHARED_DATA();
    for (const auto& entry : fs::recursive_directory_iterator(test::sharedData() / "meshes"))
        if (entry.is_regular_file() && entry.path().parent_path() != test::sharedData() / "meshes") {
            const Model model = readModel(entry.path());
            expectValid(model);
            EXPECT_EQ(model.faces, 5522u);
            EXPECT_EQ(model.meshes[0].name, entry.path().stem().string());
        }
}

TEST(RealMeshes, BrokenFilesGiveAMessageOrAValidMeshAtOnce) {
    CHIARO_NEEDS_SHARED_DATA();
    // Unusual, yet whole: these must load.
    const std::map<std::string, std::size_t> whole{
        {"box_UTF16BE.obj", 12}, {"deg_faces.obj", 4}, {"nancolor.obj", 12}, {"notenoughindices.obj", 1}};
    for (const fs::path& path : test::filesIn(test::sharedData() / "broken" / "meshes")) {
        SCOPED_TRACE(path.filename());
        const auto start = std::chrono::steady_clock::now();
        const auto found = whole.find(path.filename().string());
        try {
            const Model model = readModel(path);
            expectValid(model);
            ASSERT_NE(found, whole.end());
            EXPECT_EQ(model.faces, found->second);
        } catch (const Error& error) {
            const std::string text = error.what();
            EXPECT_EQ(found, whole.end()) << text;
            EXPECT_TRUE(text.starts_with(path.string() + ": ")) << text;
            EXPECT_EQ(text.find('\n'), text.npos) << text;
        }
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
    }
}

TEST(RealMeshes, OpenMeshesShowTheirInsides) {
    CHIARO_NEEDS_SHARED_DATA();
    const Model model = readModel(test::sharedData() / "meshes" / "cube_no_bottom.obj");
    Scene scene = test::sceneOf({model.meshes[0]});
    Camera camera;
    camera.elevation = -80;  // through the opening
    camera = camera.framed(boundsOf(scene));
    const GBuffer gbuffer = castGBuffer(RayScene(scene), scene.lights, camera, 100, 100);
    int inside = 0;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            if (gbuffer.objectId(x, y) == 0) continue;
            const Mesh& mesh = *scene.objects[0].mesh;
            const Triangle& triangle = mesh.triangles[gbuffer.faceId(x, y)];
            const glm::vec3 given = mesh.normals[triangle[0]];
            const glm::vec3 seen = gbuffer.normal(x, y);
            inside += glm::dot(given, seen) < -0.5f;
        }
    EXPECT_GT(inside, 1000);
}

}  // namespace
}  // namespace chiaro::scene
