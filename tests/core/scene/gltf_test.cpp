#include "core/base/error.h"
#include "core/scene/mesh_io.h"
#include "tests/core/scene/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>

namespace chiaro::scene {
namespace {

using nlohmann::json;

/// A glTF with one buffer: four corners of a square as floats (48 bytes), then indices 0 1 2 3 as bytes.
class Gltf : public ::testing::Test {
protected:
    Gltf() {
        for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 1.f, 1.f, 0.f})
            m_buffer.append(reinterpret_cast<const char*>(&value), sizeof value);
        m_buffer += std::string("\0\1\2\3", 4);
        m_json = json::parse(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
            "nodes":[{"mesh":0,"name":"square"}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":5}]}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
                         {"bufferView":1,"componentType":5121,"count":4,"type":"SCALAR"}],
            "bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":4}],
            "buffers":[{"uri":"square.bin","byteLength":52}]})");
    }

    Model read() {
        test::writeBytes(m_folder / "square.bin", m_buffer);
        test::writeBytes(m_folder / "a.gltf", m_json.dump());
        return readModel(m_folder / "a.gltf");
    }
    std::string complaint() {
        try {
            read();
        } catch (const Error& error) {
            return error.what();
        }
        return "no complaint";
    }
    void expectComplaint(const std::string& about) {
        const std::string text = complaint();
        EXPECT_NE(text.find(about), text.npos) << text;
    }

    test::TemporaryFolder m_folder;
    std::string m_buffer;
    json m_json;
};

TEST_F(Gltf, StripsFansAndListsBecomeTriangles) {
    EXPECT_EQ(read().meshes[0].triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}));
    m_json["meshes"][0]["primitives"][0]["mode"] = 6;
    EXPECT_EQ(read().meshes[0].triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    m_json["meshes"][0]["primitives"][0]["mode"] = 4;
    EXPECT_EQ(read().meshes[0].triangles, (std::vector<Triangle>{{0, 1, 2}}));
    m_json["meshes"][0]["primitives"][0].erase("indices");
    EXPECT_EQ(read().meshes[0].triangles, (std::vector<Triangle>{{0, 1, 2}}));
    m_json["meshes"][0]["primitives"][0]["mode"] = 1;
    expectComplaint("has no faces");
}

TEST_F(Gltf, NodeTransformsNestAndMirrorsKeepTheFront) {
    m_json["nodes"] = json::parse(R"([{"children":[2,1],"translation":[10,0,0]},
        {"mesh":0,"name":"mirrored","scale":[-1,1,1]},
        {"mesh":0,"name":"turned","rotation":[0,0,0.70710678,0.70710678],"scale":[2,1,1]}])");
    const Model model = read();
    ASSERT_EQ(model.meshes.size(), 2u);
    EXPECT_EQ(model.meshes[0].name, "turned");
    EXPECT_LT(glm::length(model.meshes[0].positions[1] - glm::vec3(10, 2, 0)), 1e-5f);
    EXPECT_EQ(model.meshes[1].name, "mirrored");
    EXPECT_EQ(model.meshes[1].positions[1], glm::vec3(9, 0, 0));
    for (const Mesh& mesh : model.meshes) EXPECT_LT(glm::length(mesh.normals[0] - glm::vec3(0, 0, 1)), 1e-6f);
}

TEST_F(Gltf, SparseAccessorsReplaceSomeVertices) {
    m_json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", 1}, {"byteOffset", 1}, {"componentType", 5121}}},
        {"values", {{"bufferView", 0}, {"byteOffset", 36}}}};
    EXPECT_EQ(read().meshes[0].positions[1], glm::vec3(1, 1, 0));
    m_json["accessors"][0]["sparse"]["indices"]["bufferView"] = 7;
    expectComplaint("buffer view");
}

TEST_F(Gltf, FilesOutsideTheFolderAreNotTouched) {
    for (const std::string uri :
         {"/etc/hostname", "../square.bin", "a/../../square.bin", "%2e%2e/square.bin"}) {
        m_json["buffers"][0]["uri"] = uri;
        expectComplaint("outside its folder");
    }
    m_json["buffers"][0]["uri"] = "missing.bin";
    expectComplaint("is damaged");
}

TEST_F(Gltf, NothingReadsBeyondItsBuffer) {
    const json whole = m_json;
    const auto expectDamaged = [&](const json& pointer, const json& value) {
        m_json = whole;
        m_json[json::json_pointer(pointer.get<std::string>())] = value;
        SCOPED_TRACE(pointer.dump() + " = " + value.dump());
        expectComplaint("is damaged");
    };
    expectDamaged("/accessors/0/count", 5);
    expectDamaged("/accessors/0/count", 50000000);
    expectDamaged("/accessors/0/byteOffset", 4);
    expectDamaged("/accessors/0/byteOffset", 18446744073709551612u);
    expectDamaged("/accessors/0/type", "VEC2");
    expectDamaged("/accessors/1/componentType", 5123);
    expectDamaged("/accessors/1/byteOffset", 1);
    expectDamaged("/accessors/0/bufferView", 9);
    expectDamaged("/bufferViews/0/byteOffset", 8);
    expectDamaged("/bufferViews/0/byteLength", 4000000000u);
    expectDamaged("/bufferViews/0/byteStride", 8);
    expectDamaged("/bufferViews/0/byteStride", 252);
    expectDamaged("/bufferViews/0/buffer", 3);
    expectDamaged("/meshes/0/primitives/0/attributes/POSITION", 12);
    expectDamaged("/meshes/0/primitives/0/attributes/POSITION", -4);
    expectDamaged("/meshes/0/primitives/0/indices", 12);
    expectDamaged("/meshes/0/primitives/0/mode", 17);
    expectDamaged("/nodes/0/mesh", 5);
    expectDamaged("/nodes/0/children", {0});
    expectDamaged("/nodes/0/children", {44});
    expectDamaged("/scenes/0/nodes", {3});
    expectDamaged("/scene", 2);
    expectDamaged("/buffers/0/byteLength", 4000000000u);
    m_json = whole;
    m_buffer[51] = 4;
    expectComplaint("a face names vertex 4 of 4");
}

TEST_F(Gltf, NodesThatFormARingEnd) {
    m_json["nodes"] = json::parse(R"([{"children":[1]},{"children":[0],"mesh":0}])");
    expectComplaint("two parents");
}

TEST_F(Gltf, CompressedFilesAreNamedAsSuch) {
    m_json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    expectComplaint("is compressed");
}

TEST_F(Gltf, VerticesMustBeFinite) {
    m_json["nodes"][0]["scale"] = {1e300, 1e300, 1e300};
    expectComplaint("not finite");
}

}  // namespace
}  // namespace chiaro::scene
