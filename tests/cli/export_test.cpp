#include "core/base/atomic_file.h"
#include "core/base/image_io.h"
#include "core/scene/mesh_io.h"
#include "tests/cli/program.h"
#include "tests/support/support.h"

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <algorithm>

namespace chiaro::test {
namespace {

const std::string oil = resource("demo/samples/oil.png").string();

/// Two squares side by side, each an object.
const char* const squares =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 3 0 0\nv 3 1 0\nv 2 1 0\n"
    "o left\nf 1 2 3 4\no right\nf 5 6 7 8\n";

/// A command that paints them quickly.
std::vector<std::string> exportTo(const std::filesystem::path& output, const std::filesystem::path& mesh,
                                  std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{
        "export", "--mesh",       mesh,           "--sample",      oil, "-o",
        output,   "--method",     "view-aligned", "--view-count",  "4", "--view-size",
        "64",     "--level-size", "64",           "--level-count", "2", "--atlas",
        "256",    "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(Export, TellsWhatTheContractNames) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "squares.obj", squares);
    const Outcome outcome = chiaro(exportTo(folder / "out/painted.glb", folder / "squares.obj"));
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const nlohmann::json json = outcome.json();
    EXPECT_EQ(json["faces"], 4);
    EXPECT_EQ(json["objects"], 2);
    EXPECT_EQ(json["charts"], 2);
    EXPECT_EQ(json["overlap"], 0);
    EXPECT_GT(json["coverage"].get<double>(), 0.4);
    EXPECT_LE(json["coverage"].get<double>(), 1);
    EXPECT_GT(json["texel_density_p5"].get<double>(), 100);
    EXPECT_LT(json["texel_density_p95"].get<double>(), 256);
    EXPECT_NEAR(json["texel_density_p95"].get<double>(), json["texel_density_p5"].get<double>(), 0.01);
    const scene::Model model = scene::readModel(folder / "out/painted.glb");
    ASSERT_EQ(model.meshes.size(), 2u);
    EXPECT_EQ(model.meshes[1].name, "right");
    EXPECT_EQ(model.faces, 4u);
}

TEST(Export, WritesTheOtherFormatsToo) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "squares.obj", squares);
    ASSERT_EQ(chiaro(exportTo(folder / "a b.obj", folder / "squares.obj", {"--bake", "texture"})).status, 0);
    EXPECT_EQ(scene::readModel(folder / "a b.obj").meshes.size(), 2u);
    const DecodedImage texture = readImage(folder / "a_b.png");
    EXPECT_EQ(texture.width, 256);
    EXPECT_NE(readFile(folder / "a_b.mtl", 4096).find("map_Kd a_b.png"), std::string::npos);
    EXPECT_NE(readImageMetadata(folder / "a_b.png").at("chiaro:parameters").find("\"bake\":\"texture\""),
              std::string::npos);
    const Outcome ply = chiaro(exportTo(folder / "a.ply", folder / "squares.obj"));
    ASSERT_EQ(ply.status, 0) << ply.error;
    EXPECT_EQ(ply.json()["charts"], 0);
    EXPECT_EQ(scene::readModel(folder / "a.ply").faces, 4u);
}

TEST(Export, ReplacesOnlyWhatItMay) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "squares.obj", squares);
    writeFileAtomically(folder / "a.glb", "mine");
    const Outcome refused = chiaro(exportTo(folder / "a.glb", folder / "squares.obj"));
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.error.find("--overwrite"), std::string::npos) << refused.error;
    EXPECT_EQ(readFile(folder / "a.glb", 10), "mine");
    const Outcome done = chiaro(exportTo(folder / "a.glb", folder / "squares.obj", {"--overwrite"}));
    EXPECT_EQ(done.status, 0) << done.error;
    EXPECT_EQ(scene::readModel(folder / "a.glb").faces, 4u);
    EXPECT_EQ(filesIn(folder.path()).size(), 2u);
}

TEST(Export, RefusesWhatCannotBe) {
    const TemporaryFolder folder;
    const std::filesystem::path mesh = folder / "squares.obj";
    writeFileAtomically(mesh, squares);
    for (const auto& [status, arguments] : std::vector<std::pair<int, std::vector<std::string>>>{
             {2, exportTo(folder / "a.fbx", mesh)},
             {1, exportTo(mesh, mesh, {"--overwrite"})},
             {1, exportTo(mesh / "below/a.glb", mesh)},
             {1, exportTo("/proc/a.glb", mesh)},  // nobody may write there
             {1, exportTo("/proc/a.html", mesh)},
             {1, exportTo(folder / "out/a.glb", folder / "missing.obj")},
             {2, exportTo(folder / "out/a.glb", mesh, {"--padding", "65"})},
             {2, exportTo(folder / "out/a.glb", mesh, {"--bake", "toast"})},
             {2, {"export", "--mesh", mesh, "--sample", oil}}}) {
        const Outcome outcome = chiaro(arguments);
        EXPECT_EQ(outcome.status, status) << outcome.error;
        EXPECT_TRUE(outcome.error.starts_with("chiaro: ")) << outcome.error;
        EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
        EXPECT_EQ(filesIn(folder.path()).size(), 1u);
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }
}

/// What a file holds as assimp reads it, which shares no code with us.
struct Counts {
    std::size_t objects = 0, faces = 0, places = 0;  ///< places: vertices with texture coordinates

    explicit Counts(const std::filesystem::path& file) {
        Assimp::Importer importer;
        const aiScene* scene = importer.ReadFile(file.string(), 0);
        EXPECT_TRUE(scene) << importer.GetErrorString();
        if (!scene) return;
        objects = scene->mNumMeshes;
        for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
            faces += scene->mMeshes[i]->mNumFaces;
            if (scene->mMeshes[i]->HasTextureCoords(0)) places += scene->mMeshes[i]->mNumVertices;
        }
    }
};

/// A mesh keeps its faces, its objects and its texture coordinates in a GLB, as our importer and assimp read
/// it.
void expectKept(const std::filesystem::path& mesh, const std::filesystem::path& output) {
    SCOPED_TRACE(mesh.filename());
    std::vector<std::string> arguments = exportTo(output, mesh, {"--overwrite"});
    std::ranges::replace(arguments, std::string("256"), std::string("1024"));  // room for many charts
    const Outcome outcome = chiaro(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const nlohmann::json json = outcome.json();
    const scene::Model before = scene::readModel(mesh), after = scene::readModel(output);
    EXPECT_EQ(json["overlap"], 0);
    EXPECT_EQ(json["faces"], before.faces);
    EXPECT_EQ(after.faces, before.faces);
    ASSERT_EQ(after.meshes.size(), before.meshes.size());
    std::size_t vertices = 0;
    for (std::size_t i = 0; i < after.meshes.size(); ++i) {
        EXPECT_EQ(after.meshes[i].name, before.meshes[i].name);
        EXPECT_EQ(after.meshes[i].triangles.size(), before.meshes[i].triangles.size());
        vertices += after.meshes[i].positions.size();
    }
    EXPECT_EQ(json["vertices"], vertices);
    const Counts counts(output);
    EXPECT_EQ(counts.objects, before.meshes.size());
    EXPECT_EQ(counts.faces, before.faces);
    EXPECT_EQ(counts.places, vertices);
}

TEST(Export, OfTheDemoKeepsFacesObjectsAndCoordinates) {
    const TemporaryFolder folder;
    for (const char* name : {"skull.glb", "still_life.obj", "shell.ply"}) {
        const std::filesystem::path mesh = resource(std::string("demo/meshes/") + name);
        expectKept(mesh, folder / "a.glb");
    }
}

TEST(Export, OfRealMeshesKeepsFacesObjectsAndCoordinates) {
    CHIARO_NEEDS_SHARED_DATA();
    const TemporaryFolder folder;
    constexpr std::uintmax_t slow = 4 << 20;  // bytes
    for (const std::filesystem::path& mesh : filesIn(sharedData() / "meshes"))
        if (std::filesystem::file_size(mesh) < slow) expectKept(mesh, folder / "a.glb");
}

}  // namespace
}  // namespace chiaro::test
