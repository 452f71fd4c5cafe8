#include "core/scene/mesh_import.h"

#include "core/base/error.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace chiaro::scene {
namespace {

using namespace test;

std::string refusalOf(const std::function<void()>& read) {
    try {
        read();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

std::vector<std::filesystem::path> meshes() {
    std::vector<std::filesystem::path> files = filesIn(resource("demo"));
    if (haveSharedData())
        for (const char* folder : {"meshes", "broken/meshes"})
            for (const auto& path : filesIn(sharedData() / folder)) files.push_back(path);
    std::erase_if(files, [](const auto& path) { return std::filesystem::file_size(path) > 3'000'000; });
    return files;
}

void expectSame(const Model& a, const Model& b, const std::filesystem::path& path) {
    ASSERT_EQ(a.meshes.size(), b.meshes.size()) << path;
    for (std::size_t i = 0; i < a.meshes.size(); ++i) {
        EXPECT_EQ(a.meshes[i].name, b.meshes[i].name) << path;
        EXPECT_EQ(a.meshes[i].positions, b.meshes[i].positions) << path;
        EXPECT_EQ(a.meshes[i].normals, b.meshes[i].normals) << path;
        EXPECT_EQ(a.meshes[i].triangles, b.meshes[i].triangles) << path;
    }
    EXPECT_EQ(std::tuple(a.faces, a.degenerateFaces, a.nonManifoldEdges, a.boundaryEdges, a.warnings),
              std::tuple(b.faces, b.degenerateFaces, b.nonManifoldEdges, b.boundaryEdges, b.warnings))
        << path;
}

/// The same mesh or the same sentence, wherever a file is read.
TEST(MeshImport, GivesWhatReadingHereGives) {
    helper::HelperPool pool({});
    for (const auto& path : meshes()) {
        Model here, there;
        const std::string refusedHere = refusalOf([&] { here = readModel(path); });
        const std::string refusedThere = refusalOf([&] { there = importModel(pool, path, {}); });
        EXPECT_EQ(refusedHere, refusedThere);
        expectSame(here, there, path);
    }
}

bool isValid(const Model& model) {
    std::size_t faces = 0;
    for (const Mesh& mesh : model.meshes) {
        faces += mesh.triangles.size();
        if (mesh.normals.size() != mesh.positions.size()) return false;
        for (const Triangle& triangle : mesh.triangles)
            for (const std::uint32_t vertex : triangle)
                if (vertex >= mesh.positions.size()) return false;
        for (const auto* list : {&mesh.positions, &mesh.normals})
            for (const glm::vec3& vector : *list)
                if (!std::isfinite(vector.x + vector.y + vector.z)) return false;
    }
    return faces == model.faces && faces > 0;
}

/// A file may hold bytes that no sentence can.
TEST(MeshImport, ARefusalQuotesTheFileReadably) {
    const TemporaryFolder folder;
    const auto path = folder / "odd.obj";
    std::ofstream(path) << std::string("v 0 0 x\0\x1b\n", 10);
    const std::string refusal = refusalOf([&] { readModel(path); });
    EXPECT_NE(refusal.find("line 1"), refusal.npos) << refusal;
    EXPECT_NE(refusal.find("; "), refusal.npos) << refusal;
    EXPECT_TRUE(std::ranges::all_of(refusal, [](char c) { return c < 0 || c >= ' '; })) << refusal;
}

/// Its corners would count the vertices of another object.
TEST(MeshImport, ASolidInsideAFacetIsRefused) {
    const TemporaryFolder folder;
    const auto path = folder / "nested.stl";
    std::ofstream(path) << "solid a\nfacet normal 0 0 1\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                           "solid b\nvertex 1 1 1\nendfacet\nendsolid b\n";
    EXPECT_NE(refusalOf([&] { readModel(path); }).find("line 6: a solid begins inside a facet"),
              std::string::npos);
}

TEST(MeshImport, AnIndexThatIsNoNumberIsCalledSo) {
    const TemporaryFolder folder;
    const auto path = folder / "nan.ply";
    std::ofstream(path) << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                           "property float z\nelement face 1\nproperty list uchar float vertex_indices\n"
                           "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 nan 2\n";
    EXPECT_NE(refusalOf([&] { readModel(path); }).find("(nan of 3)"), std::string::npos);
}

/// Whatever byte of its answer a helper changes: a mesh that is one, or a sentence.
TEST(MeshImport, TrustsNoAnswer) {
    const TemporaryFolder folder;
    helper::HelperPool pool({.program = CHIARO_HOSTILE_HELPER});
    int refused = 0;
    for (std::size_t place = 0; place < 250; ++place) {
        const auto path = folder / ("lie-" + std::to_string(place) + ".obj");
        std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n";
        const std::string refusal =
            refusalOf([&] { EXPECT_TRUE(isValid(importModel(pool, path, {}))) << place; });
        if (refusal.empty()) continue;
        ++refused;
        EXPECT_TRUE(refusal.starts_with(path.string() + ": ")) << refusal;
    }
    EXPECT_GE(refused, 40);
}

}  // namespace
}  // namespace chiaro::scene
