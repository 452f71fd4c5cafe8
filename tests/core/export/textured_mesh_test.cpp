#include "core/export/textured_mesh.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/scene/mesh_io.h"
#include "tests/core/export/glb_reader.h"
#include "tests/core/views/meshes.h"
#include "tests/support/support.h"

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <glm/gtc/matrix_transform.hpp>
#include <sys/resource.h>

#include <csignal>

namespace chiaro::exporting {
namespace {

using test::TemporaryFolder;

/// A box, and next to it the same one turned and mirrored, and one that is sheared.
TexturedScene threeBoxes() {
    TexturedScene result;
    result.texture = ByteImage(64, 64, glm::u8vec3(200, 100, 50));
    glm::mat4 turned = glm::translate(glm::mat4(1), glm::vec3(5, 0, 0));
    turned = glm::scale(glm::rotate(turned, 0.7f, glm::vec3(1, 1, 0)), glm::vec3(-1, 2, 1));
    glm::mat4 sheared(1);
    sheared[1][0] = 0.5f;
    sheared[3] = {0, 9, 0, 1};
    for (const auto& [name, transform] : std::vector<std::pair<std::string, glm::mat4>>{
             {"plain", glm::mat4(1)}, {"turned \"ü\"", turned}, {"sheared", sheared}}) {
        scene::Mesh mesh = test::box({0, 0, 0}, glm::vec3(1));
        mesh.normals = scene::angleWeightedNormals(mesh);
        TexturedObject object{name, transform, mesh.positions, mesh.normals, {}, {}, mesh.triangles};
        for (std::size_t i = 0; i < 8; ++i) {
            object.coordinates.emplace_back(0.1f * float(i), 0.25f);
            object.colors.emplace_back(10 * i, 255, 0);
        }
        result.objects.push_back(std::move(object));
    }
    return result;
}

glm::vec3 centreOf(const scene::Mesh& mesh, const scene::Triangle& face) {
    return (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]) / 3.0f;
}

/// The importer's mesh holds the object's faces at their places in the world, in their order, fronts outside.
void expectSame(const scene::Mesh& mesh, const TexturedObject& object) {
    ASSERT_EQ(mesh.triangles.size(), object.triangles.size());
    const scene::Mesh own{object.name, object.positions, object.normals, object.triangles};
    const glm::vec3 middle(object.transform[3]);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::vec3 expected(object.transform * glm::vec4(centreOf(own, own.triangles[i]), 1));
        EXPECT_LT(glm::distance(centreOf(mesh, mesh.triangles[i]), expected), 1e-5f);
        const auto& [a, b, c] = mesh.triangles[i];
        const glm::vec3 front =
            glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
        EXPECT_GT(glm::dot(front, expected - middle), 0);
        for (const std::uint32_t vertex : mesh.triangles[i])
            EXPECT_GT(glm::dot(mesh.normals[vertex], front), 0);
    }
}

/// Names come from files that others made: what means something else in an OBJ file must not reach it.
TEST(WriteTexturedScene, NamesThatWouldBreakAnObjAreMended) {
    const TemporaryFolder folder;
    TexturedScene scene = threeBoxes();
    scene.objects.push_back(scene.objects[0]);
    scene.objects[0].name = "lid\nv 9 9 9 9";
    scene.objects[1].name = "a#b\\";
    scene.objects[2].name = "a_b_";
    scene.objects[3].name = " \t\r\n";
    writeTexturedScene(folder / "a.obj", scene);
    const scene::Model model = scene::readModel(folder / "a.obj");
    ASSERT_EQ(model.meshes.size(), 4u);
    const std::array names{"lid_v 9 9 9 9", "a_b_", "a_b_ 2", "object"};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(model.meshes[i].name, names[i]);
        expectSame(model.meshes[i], scene.objects[i]);
    }
}

TEST(WriteTexturedScene, ComesBackThroughOurOwnImporter) {
    const TemporaryFolder folder;
    const TexturedScene scene = threeBoxes();
    for (const char* name : {"a.glb", "a b.obj"}) {
        SCOPED_TRACE(name);
        writeTexturedScene(folder / name, scene);
        const scene::Model model = scene::readModel(folder / name);
        ASSERT_EQ(model.meshes.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(model.meshes[i].name, scene.objects[i].name);
            expectSame(model.meshes[i], scene.objects[i]);
        }
    }
    writeTexturedScene(folder / "a.ply", scene);
    const scene::Model model = scene::readModel(folder / "a.ply");
    EXPECT_EQ(model.faces, 36u);
    const std::string ply = readFile(folder / "a.ply", 1 << 20);
    EXPECT_NE(ply.find("property uchar red\n"), std::string::npos);
    const std::size_t begin = ply.find("end_header\n") + 11;
    EXPECT_EQ(std::uint8_t(ply[begin + 27 + 24]), 10);  // red of the second vertex
    EXPECT_EQ(std::uint8_t(ply[begin + 27 + 25]), 255);
}

TEST(WriteTexturedScene, ComesBackThroughAssimp) {
    const TemporaryFolder folder;
    const TexturedScene scene = threeBoxes();
    for (const char* name : {"a.glb", "a b.obj"}) {
        SCOPED_TRACE(name);
        writeTexturedScene(folder / name, scene);
        Assimp::Importer importer;
        const aiScene* read = importer.ReadFile((folder / name).string(), 0);
        ASSERT_TRUE(read) << importer.GetErrorString();
        ASSERT_EQ(read->mNumMeshes, 3u);
        for (unsigned i = 0; i < 3; ++i) {
            const aiMesh& mesh = *read->mMeshes[i];
            EXPECT_EQ(mesh.mNumFaces, 12u);
            ASSERT_TRUE(mesh.HasTextureCoords(0));
            ASSERT_TRUE(mesh.HasNormals());
            const aiFace& face = mesh.mFaces[0];  // corners 0, 2, 3; assimp's v goes up
            EXPECT_NEAR(mesh.mTextureCoords[0][face.mIndices[0]].y, 0.75f, 1e-6f);
            EXPECT_NEAR(mesh.mTextureCoords[0][face.mIndices[0]].x, 0.0f, 1e-6f);
        }
        aiString texture;
        ASSERT_GT(read->mNumMaterials, 0u);
        unsigned textured = 0;
        for (unsigned i = 0; i < read->mNumMaterials; ++i)
            textured +=
                read->mMaterials[i]->GetTexture(aiTextureType_DIFFUSE, 0, &texture) == aiReturn_SUCCESS;
        EXPECT_EQ(textured, 1u);
        const std::string file = texture.C_Str();
        EXPECT_TRUE(file.starts_with('*') || std::filesystem::exists(folder / file)) << file;
    }
}

TEST(WriteTexturedScene, TellsViewersHowToShowIt) {
    const TemporaryFolder folder;
    TexturedScene scene = threeBoxes();
    writeTexturedScene(folder / "lit.glb", scene);
    const test::GlbScene lit = test::readGlb(folder / "lit.glb");
    EXPECT_TRUE(lit.isUnlit);
    EXPECT_TRUE(lit.requiredExtensions.empty());  // a viewer that doesn't know it shows the mesh all the same
    EXPECT_EQ(lit.texture.width(), 64);
    EXPECT_NEAR(lit.texture(3, 3).r, 200 / 255.0f, 1e-6f);
    scene.bake = Bake::Texture;
    writeTexturedScene(folder / "texture.glb", scene);
    EXPECT_FALSE(test::readGlb(folder / "texture.glb").isUnlit);
}

TEST(HasModelledBacks, TellsSheetsWithTwoSides) {
    const scene::Mesh front = test::square(0);
    scene::Mesh back = front;
    for (scene::Triangle& triangle : back.triangles) std::swap(triangle[0], triangle[1]);
    EXPECT_FALSE(hasModelledBacks(front));
    EXPECT_FALSE(hasModelledBacks(scene::merged({front, front})));
    EXPECT_TRUE(hasModelledBacks(scene::merged({front, back})));
    EXPECT_FALSE(hasModelledBacks(test::box({0, 0, 0}, glm::vec3(1))));
}

TEST(WriteTexturedScene, GivesTheSameBytesAgain) {
    const TemporaryFolder folder;
    for (const char* extension : {".glb", ".obj", ".ply"}) {
        const std::filesystem::path first = folder / (std::string("a") + extension);
        writeTexturedScene(first, threeBoxes(), {{"Software", "test"}});
        const std::string bytes = readFile(first, 1 << 20);
        writeTexturedScene(first, threeBoxes(), {{"Software", "test"}});
        EXPECT_EQ(readFile(first, 1 << 20), bytes);
    }
}

TEST(MeshOutput, IsRefusedBeforeTheWork) {
    const TemporaryFolder folder;
    EXPECT_THROW(checkMeshOutput(folder / "a.fbx", true), Error);
    EXPECT_THROW(checkMeshOutput(folder / "a", true), Error);
    EXPECT_NO_THROW(checkMeshOutput(folder / "new/a.GLB", false));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    writeFileAtomically(folder / "a_b.mtl", "mine");
    EXPECT_THROW(checkMeshOutput(folder / "a b.obj", false), Error);
    EXPECT_NO_THROW(checkMeshOutput(folder / "a b.obj", true));
    EXPECT_THROW(checkMeshOutput(folder / "a_b.mtl/a.glb", true), Error);  // below a file
    EXPECT_EQ(test::filesIn(folder.path()).size(), 1u);
    EXPECT_EQ(readFile(folder / "a_b.mtl", 10), "mine");
}

/// While it lives, files of this process can't grow beyond some bytes, as on a full disk.
class SmallDisk {
public:
    explicit SmallDisk(rlim_t bytes) : m_handler(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit small{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk() {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }

private:
    void (*m_handler)(int);
    rlimit m_before{};
};

TEST(WriteTexturedScene, WritesNothingOnAFullDisk) {
    const TemporaryFolder folder;
    for (const char* name : {"a.glb", "a.obj", "a.ply"}) {
        writeFileAtomically(folder / name, "old");
        {
            const SmallDisk disk(
                400);  // enough for the picture and the material of an OBJ, not for its faces
            EXPECT_THROW(writeTexturedScene(folder / name, threeBoxes()), Error);
        }
        EXPECT_EQ(readFile(folder / name, 10), "old");
    }
    EXPECT_EQ(test::filesIn(folder.path()).size(), 3u);
}

}  // namespace
}  // namespace chiaro::exporting
