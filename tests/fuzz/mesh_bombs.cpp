#include "tests/core/base/raw_files.h"
#include "tests/fuzz/bombs.h"

namespace chiaro::test {

namespace {

Bytes plyHeader(const std::string& vertices, const std::string& faces) {
    return Bytes("ply\nformat binary_little_endian 1.0\nelement vertex ") + vertices +
           Bytes("\nproperty float x\nproperty float y\nproperty float z\nelement face ") + faces +
           "\nproperty list uint int vertex_indices\nend_header\n";
}

Bytes stl(std::uint32_t facets) {
    return Bytes(80, ' ') + littleEndian(facets, 4) + Bytes(150, '\0');
}

/// One face with more corners than triangles are read.
Bytes polygon() {
    Bytes text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
    for (int i = 0; i < 1'000'000; ++i) text += " 1 2 3";
    return text + " 99999999999999999999\n";
}

/// `members` besides the asset, a scene with all of `nodes`, and a triangle in buffer 0.
Bytes gltf(const std::string& members, const std::string& nodes = R"({"mesh":0})") {
    std::string roots = "0";
    return Bytes(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[)") + roots + Bytes(R"(]}],"nodes":[)") +
           nodes + Bytes("],") + members + "}";
}

const std::string triangleData =
    R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
    R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],"bufferViews":[{"buffer":0,"byteLength":36}])";

std::string meshOf(const std::string& accessor, int primitives = 1) {
    std::string list = R"({"attributes":{"POSITION":0}})";
    std::string all = list;
    for (int i = 1; i < primitives; ++i) all += Bytes(",") + list;
    return Bytes(R"("meshes":[{"primitives":[)") + all + Bytes(R"(]}],"accessors":[)") + accessor + "]";
}

std::string vectors(const std::string& count, const std::string& view = R"("bufferView":0,)") {
    return Bytes("{") + view + Bytes(R"("componentType":5126,"type":"VEC3","count":)") + count + "}";
}

Bytes gltfWithBuffer(const std::string& uri) {
    return gltf(meshOf(vectors("3")) + Bytes(R"(,"bufferViews":[{"buffer":0,"byteLength":36}],)") +
                Bytes(R"("buffers":[{"byteLength":36,"uri":")") + uri + R"("}])");
}

/// A list of a million zeros that no byte stands for, drawn by a hundred primitives.
Bytes manyZeros() {
    return gltf(meshOf(vectors("999999", ""), 100));
}

/// Some hundred thousand nodes that each show the same hundred triangles.
Bytes manyInstances() {
    std::string nodes = R"({"children":[1)";
    constexpr int count = 60'000;
    for (int i = 2; i <= count; ++i) nodes.append(",").append(std::to_string(i));
    nodes += "]}";
    for (int i = 0; i < count; ++i) nodes += R"(,{"mesh":0})";
    return gltf(meshOf(vectors("3"), 400) + Bytes(",") + triangleData, nodes);
}

Bytes deepExtras() {
    constexpr std::size_t depth = 2'000'000;
    return gltf(meshOf(vectors("3")) + Bytes(",") + triangleData + Bytes(R"(,"extras":)") +
                std::string(depth, '[') + std::string(depth, ']'));
}

Bytes glb(std::uint32_t length, std::uint32_t jsonLength) {
    return Bytes("glTF") + littleEndian(2, 4) + littleEndian(length, 4) + littleEndian(jsonLength, 4) +
           Bytes("JSON") + gltf(meshOf(vectors("3")) + Bytes(",") + triangleData);
}

}  // namespace

std::vector<Bomb> meshBombs() {
    return {
        {"ply_vertices", ".ply", Opened::Mesh, [] { return plyHeader("4294967295", "1") + Bytes(64, '\0'); }},
        {"ply_faces", ".ply", Opened::Mesh,
         [] { return plyHeader("1", "18446744073709551615") + Bytes(64, '\0'); }},
        {"ply_list", ".ply", Opened::Mesh,
         [] { return plyHeader("3", "1") + Bytes(36, '\0') + Bytes(4, '\xff') + Bytes(64, '\0'); }},
        {"stl_facets", ".stl", Opened::Mesh, [] { return stl(0xffffffff); }},
        {"off_counts", ".off", Opened::Mesh, [] { return Bytes("OFF\n2000000000 2000000000 0\n0 0 0\n"); }},
        {"obj_polygon", ".obj", Opened::Mesh, polygon},
        {"obj_index", ".obj", Opened::Mesh,
         [] { return Bytes("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9223372036854775808\n"); }},
        {"glb_chunk", ".glb", Opened::Mesh, [] { return glb(0xffffffff, 0xffffffff); }},
        {"gltf_count", ".gltf", Opened::Mesh, [] { return gltf(meshOf(vectors("1000000000000", ""))); }},
        {"gltf_bounds", ".gltf", Opened::Mesh,
         [] { return gltf(meshOf(vectors("1000000000")) + Bytes(",") + triangleData); }},
        {"gltf_zeros", ".gltf", Opened::Mesh, manyZeros},
        {"gltf_instances", ".gltf", Opened::Mesh, manyInstances},
        {"gltf_depth", ".gltf", Opened::Mesh, deepExtras},
        {"gltf_parent_folder", ".gltf", Opened::Mesh,
         [] { return gltfWithBuffer("../../../../etc/passwd"); }},
        {"gltf_absolute", ".gltf", Opened::Mesh, [] { return gltfWithBuffer("/dev/zero"); }},
        {"gltf_device", ".gltf", Opened::Mesh, [] { return gltfWithBuffer("file:///dev/zero"); }},
    };
}

std::vector<Bomb> jsonBombs() {
    const auto deep = [] { return Bytes(R"({"chiaro":2,"samples":)") + std::string(4'000'000, '['); };
    const auto deepSound = [] {
        return Bytes(R"({"chiaro":2,"samples":)") + std::string(1'000'000, '[') +
               std::string(1'000'000, ']') + "}";
    };
    const auto keys = [](const std::string& first) {
        std::string text = Bytes("{") + first;
        for (int i = 0; i < 300'000; ++i) text += Bytes(",\"") + std::to_string(i) + "\":0";
        return text + "}";
    };
    const auto values = [] {
        std::string text = R"({"chiaro":2,"samples":[0)";
        for (int i = 0; i < 20'000'000; ++i) text += ",0";
        return text + "]}";
    };
    return {
        {"chiaro_depth", ".chiaro", Opened::Project, deep},
        {"chiaro_closed_depth", ".chiaro", Opened::Project, deepSound},
        {"chiaro_members", ".chiaro", Opened::Project, [keys] { return keys(R"("chiaro":2)"); }},
        {"chiaro_values", ".chiaro", Opened::Project, values},
        {"path_depth", ".json", Opened::Path,
         [] {
             return Bytes(R"({"path":1,"keys":)") + std::string(1'000'000, '[') +
                    std::string(1'000'000, ']') + "}";
         }},
        {"path_members", ".json", Opened::Path, [keys] { return keys(R"("path":1)"); }},
    };
}

std::vector<Bomb> bombs() {
    std::vector<Bomb> all = imageBombs();
    for (const auto& more : {meshBombs(), jsonBombs()}) all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace chiaro::test
