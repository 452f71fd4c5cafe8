#include "core/scene/mesh_io.h"

#include "core/base/error.h"
#include "tests/core/scene/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>

namespace chiaro::scene {
namespace {

class MeshFile : public ::testing::Test {
protected:
    Model read(const std::string& name, const std::string& bytes) {
        test::writeBytes(m_folder / name, bytes);
        return readModel(m_folder / name);
    }
    /// What the reader says about such a file, without the path.
    std::string complaint(const std::string& name, const std::string& bytes) {
        try {
            read(name, bytes);
        } catch (const Error& error) {
            const std::string text = error.what();
            const std::string path = (m_folder / name).string();
            EXPECT_TRUE(text.starts_with(path + ": ")) << text;
            EXPECT_NE(text.find("; "), text.npos) << text;
            return text.substr(std::min(path.size() + 2, text.size()));
        }
        return "no complaint";
    }
    bool complains(const std::string& name, const std::string& bytes, const std::string& about) {
        const std::string text = complaint(name, bytes);
        const bool found = text.find(about) != text.npos;
        if (!found) std::cout << text << "\n";
        return found;
    }

    test::TemporaryFolder m_folder;
};

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

template <class T>
void append(std::string& bytes, T value, bool bigEndian = false) {
    char buffer[sizeof(T)];
    std::memcpy(buffer, &value, sizeof(T));
    if (bigEndian) std::reverse(buffer, buffer + sizeof(T));
    bytes.append(buffer, sizeof(T));
}

using Obj = MeshFile;

TEST_F(Obj, PolygonsBecomeFansInFileOrder) {
    const Model model = read("a.obj", square + "v 2 2 0\nf 1 2 3 4\nf 3 2 5\n");
    ASSERT_EQ(model.meshes.size(), 1u);
    const Mesh& mesh = model.meshes[0];
    EXPECT_EQ(mesh.name, "a");
    ASSERT_EQ(mesh.triangles.size(), 3u);
    const auto corner = [&](std::size_t f, std::size_t k) { return mesh.positions[mesh.triangles[f][k]]; };
    EXPECT_EQ(corner(0, 2), glm::vec3(1, 1, 0));
    EXPECT_EQ(corner(1, 0), glm::vec3(0, 0, 0));
    EXPECT_EQ(corner(1, 1), glm::vec3(1, 1, 0));
    EXPECT_EQ(corner(1, 2), glm::vec3(0, 1, 0));
    EXPECT_EQ(corner(2, 2), glm::vec3(2, 2, 0));
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(model.faces, 3u);
}

TEST_F(Obj, ObjectsAreKeptApartByNameInFileOrderAcrossMaterials) {
    const Model model =
        read("a.obj", square +
                          "o tooth\nusemtl x\nf 1 2 3\nusemtl y\nf 1 3 4\ng part\nusemtl x\nf 1 2 4\n"
                          "o jaw\nf 1 2 3\no empty\no tooth\nf 2 3 4\n");
    ASSERT_EQ(model.meshes.size(), 3u);
    EXPECT_EQ(model.meshes[0].name, "tooth");
    EXPECT_EQ(model.meshes[0].triangles.size(), 3u);
    EXPECT_EQ(model.meshes[1].name, "jaw");
    EXPECT_EQ(model.meshes[1].positions.size(), 3u);
    EXPECT_EQ(model.meshes[2].name, "tooth (2)");
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_EQ(model.warnings[0], "1 object without faces was left out.");
}

TEST_F(Obj, GroupsAreObjectsWhereNoObjectIsNamed) {
    const Model model = read("a.obj", square + "g left eye\nf 1 2 3\ng right\nf 1 3 4\n");
    ASSERT_EQ(model.meshes.size(), 2u);
    EXPECT_EQ(model.meshes[0].name, "left eye");
    EXPECT_EQ(model.meshes[1].name, "right");
}

TEST_F(Obj, NegativeForwardAndContinuedIndicesMeanWhatTheyShould) {
    const Model model = read("a.obj", square + "f -4 -3 -2\nf 1 \\\n 2 5\nv 7 7 7\n");
    ASSERT_EQ(model.faces, 2u);
    EXPECT_EQ(model.meshes[0].positions[model.meshes[0].triangles[0][0]], glm::vec3(0, 0, 0));
    EXPECT_EQ(model.meshes[0].positions[model.meshes[0].triangles[1][2]], glm::vec3(7, 7, 7));
}

TEST_F(Obj, SplitNormalsKeepCreasesAndBrokenOnesAreComputed) {
    const Model model = read("a.obj", square +
                                          "vn 0 0 2\nvn 0 1 1\nvn nan 0 0\nvn 0 0 0\n"
                                          "f 1//1 2//1 3//1\nf 1//2 3//3 4//4\n");
    const Mesh& mesh = model.meshes[0];
    EXPECT_EQ(mesh.positions.size(), 6u) << "vertices 1 and 3 have two normals each";
    EXPECT_EQ(mesh.normals[mesh.triangles[0][0]], glm::vec3(0, 0, 1));
    EXPECT_LT(glm::length(mesh.normals[mesh.triangles[1][0]] - glm::vec3(0, 1, 1) / std::sqrt(2.0f)), 1e-6f);
    EXPECT_EQ(mesh.normals[mesh.triangles[1][1]], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[mesh.triangles[1][2]], glm::vec3(0, 0, 1));
}

TEST_F(Obj, NormalsThatHaveNothingToDoWithTheFacesAreComputed) {
    const Model model = read("a.obj", square + "vn 1 0 0\nf 1//1 2//1 3//1 4//1\n");
    EXPECT_EQ(model.meshes[0].normals[0], glm::vec3(0, 0, 1));
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_EQ(model.warnings[0], "4 normals in the file made no sense and were computed instead.");
}

TEST_F(Obj, BadInputIsToldWithItsLine) {
    EXPECT_TRUE(complains("a.obj", square + "f 1 2 9\n", "line 5: the face names vertex 9 of 4"));
    EXPECT_TRUE(complains("a.obj", square + "f 0 1 2\n", "vertex 0"));
    EXPECT_TRUE(complains("a.obj", square + "f -5 1 2\n", "vertex -5"));
    EXPECT_TRUE(complains("a.obj", square + "f 1//3 2//3 3//3\n", "normal 3 of 0"));
    EXPECT_TRUE(complains("a.obj", square + "f 1 2 99999999999999999999\n", "is no index"));
    EXPECT_TRUE(complains("a.obj", square + "f a b c\n", "\"a\" is no index"));
    EXPECT_TRUE(complains("a.obj", "v 0 nan 0\n", "line 1: the vertex is not finite"));
    EXPECT_TRUE(complains("a.obj", "v 0 1e999 0\n", "not finite"));
    EXPECT_TRUE(complains("a.obj", "v 0 1e30 0\nv 1 0 0\nv 0 0 0\nf 1 2 3", "1e15"));
    EXPECT_TRUE(complains("a.obj", "v 0 1\n", "fewer than three"));
    EXPECT_TRUE(complains("a.obj", square, "has no faces"));
    EXPECT_TRUE(complains("a.obj", square + "f 1 2\n", "has no faces"));
    EXPECT_TRUE(complains("a.obj", "", "is empty"));
    EXPECT_TRUE(complains("a.xyz", square, "is no mesh format"));
    EXPECT_THROW(readModel(m_folder / "missing.obj"), Error);
    EXPECT_THROW(readModel(m_folder.path()), Error);
}

TEST_F(Obj, NamesAreCleanedSoThatTheyCanBeSaved) {
    const Model model =
        read("a.obj", square + "o caf\xE9\nf 1 2 3\no \xD1\x87\xD0\xB5\nf 1 2 3\no a\tb\nf 1 2 3\n");
    EXPECT_EQ(model.meshes[0].name, "caf?");
    EXPECT_EQ(model.meshes[1].name, "\xD1\x87\xD0\xB5");
    EXPECT_EQ(model.meshes[2].name, "ab");
}

TEST_F(Obj, ManyObjectsOfOneNameAndManyNormalsOfOneVertexTakeNoLongerThanOthers) {
    std::string objects = square;
    for (int i = 0; i < 30000; ++i) objects += "o x\nf 1 2 3\n";
    EXPECT_EQ(read("a.obj", objects).meshes.back().name, "x (30000)");
    std::string normals = square;
    for (int i = 1; i <= 30000; ++i)
        normals += "vn 0 0 1\nf 1//" + std::to_string(i) + " 2//" + std::to_string(i) + " 3//" +
                   std::to_string(i) + "\n";
    EXPECT_EQ(read("a.obj", normals).meshes[0].positions.size(), 90000u);
}

using Ply = MeshFile;

std::string binaryPly(bool bigEndian, std::uint32_t lastIndex = 3) {
    std::string bytes = std::string("ply\r\nformat binary_") + (bigEndian ? "big" : "little") +
                        "_endian 1.0\r\ncomment x\r\nelement face 1\r\nproperty uchar red\r\n"
                        "property list ushort uint vertex_index\r\nproperty list uchar float texcoord\r\n"
                        "element vertex 4\r\nproperty double z\r\nproperty uchar red\r\nproperty short y\r\n"
                        "property float x\r\nend_header\r\n";
    append<std::uint8_t>(bytes, 200);
    append<std::uint16_t>(bytes, 4, bigEndian);
    for (const std::uint32_t index : {0u, 1u, 2u, lastIndex}) append(bytes, index, bigEndian);
    append<std::uint8_t>(bytes, 1);
    append(bytes, 0.5f, bigEndian);
    for (const auto& [x, y] : {std::pair(0.0f, 0), {1.0f, 0}, {1.0f, 1}, {0.0f, 1}}) {
        append(bytes, 0.25, bigEndian);
        append<std::uint8_t>(bytes, 7);
        append(bytes, std::int16_t(y), bigEndian);
        append(bytes, x, bigEndian);
    }
    return bytes;
}

TEST_F(Ply, BothBinaryOrdersAnyPropertiesFacesFirst) {
    for (const bool bigEndian : {false, true}) {
        const Model model = read("a.ply", binaryPly(bigEndian));
        ASSERT_EQ(model.faces, 2u);
        EXPECT_EQ(model.meshes[0].positions[2], glm::vec3(1, 1, 0.25f));
        EXPECT_EQ(model.meshes[0].triangles[1], (Triangle{0, 2, 3}));
        EXPECT_EQ(model.boundaryEdges, 4u);
    }
}

TEST_F(Ply, AsciiWithNormalsStripsAndNanColours) {
    const Model model =
        read("a.ply",
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
             "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
             "property float red\nelement tristrips 1\nproperty list int int vertex_indices\n"
             "end_header\n0 0 0 0 0 3 nan\n1 0 0 0 0 3 nan\n0 1 0 0 0 3 nan\n1 1 0 0 0 3 nan\n"
             "8 0 1 2 3 -1 0 1 2\n");
    ASSERT_EQ(model.faces, 3u);
    EXPECT_EQ(model.meshes[0].triangles[1], (Triangle{2, 1, 3}));
    EXPECT_EQ(model.meshes[0].triangles[2], (Triangle{0, 1, 2}));
    EXPECT_EQ(model.meshes[0].normals[3], glm::vec3(0, 0, 1));
}

TEST_F(Ply, EveryTruncationIsToldOrHarmless) {
    const std::string whole = binaryPly(false);
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_NE(complaint("a.ply", whole.substr(0, size)), "no complaint") << size;
}

TEST_F(Ply, BadInput) {
    EXPECT_TRUE(complains("a.ply", binaryPly(true, 4), "not there (4 of 4)"));
    const std::string vertex = "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
    EXPECT_TRUE(complains("a.ply",
                          "ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nproperty "
                          "float y\nproperty float z\nend_header\n",
                          "more than the file has room for"));
    EXPECT_TRUE(complains("a.ply",
                          "ply\nformat ascii 1.0\n" + vertex +
                              "element face 1\nproperty list char int "
                              "vertex_index\nend_header\n0 0 0\n-3 0 0 0\n",
                          "a list promises -3"));
    EXPECT_TRUE(complains("a.ply",
                          "ply\nformat ascii 1.0\n" + vertex +
                              "element face 1\nproperty list uint int "
                              "vertex_index\nend_header\n0 0 0\n4000000000 0 0 0\n",
                          "a list promises 4000000000"));
    EXPECT_TRUE(
        complains("a.ply", "ply\nformat ascii 1.0\n" + vertex + "end_header\n0 x 0\n", "is no number"));
    EXPECT_TRUE(complains("a.ply",
                          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                          "property float z\nelement face 1\nproperty list uchar int vertex_index\n"
                          "end_header\n0 0 0\n0 inf 0\n1 1 1\n3 0 1 2\n",
                          "not finite"));
    EXPECT_TRUE(complains("a.ply", "ply\nformat ascii 1.0\n" + vertex + vertex + "end_header\n0 0 0\n0 0 0\n",
                          "declare them once"));
    EXPECT_TRUE(complains("a.ply", "ply\nformat morse 1.0\nend_header\n", "header line 2: unknown format"));
}

using Off = MeshFile;

TEST_F(Off, CountsOnEitherLineCommentsColoursNormals) {
    const std::string faces = "4 0 1 2 3 255 0 0\n";
    const Model plain = read("a.off", "OFF # made by hand\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + faces);
    EXPECT_EQ(plain.meshes[0].triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    const Model normals =
        read("a.off", "NOFF 4 1 0\n0 0 0 0 0 -1\n1 0 0 0 0 -1\n1 1 0 0 0 -1\n0 1 0 0 0 -1\n" + faces);
    EXPECT_EQ(normals.meshes[0].normals[0], glm::vec3(0, 0, -1));
}

TEST_F(Off, BadInput) {
    EXPECT_TRUE(complains("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n", "ends after 2 of 4 vertices"));
    EXPECT_TRUE(complains("a.off", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "vertex 1 of 1"));
    EXPECT_TRUE(complains("a.off", "OFF\n1 1 0\n0 0 0\n3 0 0\n", "fewer corners"));
    EXPECT_TRUE(complains("a.off", "OFF\n1 1 0\n0 0 0\n9999999999 0 0\n", "fewer corners"));
    EXPECT_TRUE(complains("a.off", "OFF\n-1 1 0\n", "is no number of vertices"));
    EXPECT_TRUE(complains("a.off", "OFF BINARY\n", "binary OFF"));
    EXPECT_TRUE(complains("a.off", "4OFF\n", "is no OFF that is read"));
}

using Stl = MeshFile;

std::string binaryStl(std::uint32_t promised, int facets) {
    std::string bytes(80, ' ');
    bytes.replace(0, 5, "solid");
    append(bytes, promised);
    for (int f = 0; f < facets; ++f) {
        for (const float value : {0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, float(f)})
            append(bytes, value);
        append<std::uint16_t>(bytes, 0);
    }
    return bytes;
}

TEST_F(Stl, BinaryIsToldFromTextByItsSize) {
    const Model model = read("a.stl", binaryStl(2, 2));
    EXPECT_EQ(model.faces, 2u);
    EXPECT_EQ(model.boundaryEdges, 4u);
    EXPECT_EQ(model.meshes[0].positions.size(), 6u) << "45 degrees is a crease: both of its ends are split";
}

TEST_F(Stl, TextMayHoldSeveralSolids) {
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    const Model model =
        read("a.stl", "solid left part\n" + facet + "endsolid\nsolid\n" + facet + facet + "endsolid\n");
    ASSERT_EQ(model.meshes.size(), 2u);
    EXPECT_EQ(model.meshes[0].name, "left part");
    EXPECT_EQ(model.meshes[1].name, "a");
    EXPECT_EQ(model.meshes[1].triangles.size(), 2u);
}

TEST_F(Stl, BadInput) {
    EXPECT_TRUE(complains("a.stl", binaryStl(4000000000u, 1), "promises 4000000000 facets"));
    EXPECT_TRUE(complains("a.stl", binaryStl(2, 2).substr(0, 170), "promises 2 facets"));
    EXPECT_TRUE(complains("a.stl", std::string("\x01\x02", 2), "promises 0 facets"));
    EXPECT_TRUE(
        complains("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "inside a facet"));
    EXPECT_TRUE(complains("a.stl", "solid x\nendsolid x\n", "has no faces"));
}

TEST_F(MeshFile, Utf16TextIsRead) {
    std::string bytes = "\xFF\xFE";
    for (const char c : square + "o \x01\nf 1 2 3\n")
        bytes += {c == '\x01' ? '\x16' : c, c == '\x01' ? '\x04' : '\0'};
    const Model model = read("a.obj", bytes);
    EXPECT_EQ(model.faces, 1u);
    EXPECT_EQ(model.meshes[0].name, "\xD0\x96");
}

TEST_F(MeshFile, PathsMayHoldAnyLetters) {
    const auto path = m_folder.path() / u8"папка 骨" / u8"goat's #1 (копия).obj";
    test::writeBytes(path, square + "f 1 2 3 4\n");
    EXPECT_EQ(readModel(path).meshes[0].name, reinterpret_cast<const char*>(u8"goat's #1 (копия)"));
}

TEST_F(MeshFile, LoadingCanBeCancelled) {
    std::stop_source stop;
    stop.request_stop();
    test::writeBytes(m_folder / "a.obj", square + "f 1 2 3 4\n");
    EXPECT_THROW(readModel(m_folder / "a.obj", Task(stop.get_token())), Cancelled);
}

}  // namespace
}  // namespace chiaro::scene
