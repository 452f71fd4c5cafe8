#include "core/export/mesh_writers.h"

#include <spdlog/fmt/fmt.h>

#include <bit>
#include <cstring>

namespace chiaro::exporting {

namespace {

static_assert(std::endian::native == std::endian::little, "values are written as they lie in memory");

template <class Value>
void append(std::string& bytes, const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(Value));
}

}  // namespace

std::string plyBytes(const TexturedScene& scene, const ImageMetadata& metadata) {
    std::size_t vertices = 0, faces = 0;
    for (const TexturedObject& object : scene.objects) {
        vertices += object.positions.size();
        faces += object.triangles.size();
    }
    std::string bytes = "ply\nformat binary_little_endian 1.0\n";
    for (const auto& [key, value] : metadata) bytes += fmt::format("comment {}: {}\n", key, value);
    bytes += fmt::format("element vertex {}\n", vertices);
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
        bytes += fmt::format("property float {}\n", name);
    for (const char* name : {"red", "green", "blue"}) bytes += fmt::format("property uchar {}\n", name);
    bytes += fmt::format("element face {}\nproperty list uchar uint vertex_indices\nend_header\n", faces);
    for (const TexturedObject& object : scene.objects) {
        const PlacedVertices placed(object);
        for (std::size_t i = 0; i < object.positions.size(); ++i) {
            append(bytes, placed.position(object.positions[i]));
            append(bytes, placed.normal(object.normals[i]));
            append(bytes, object.colors[i]);
        }
    }
    std::uint32_t first = 0;
    for (const TexturedObject& object : scene.objects) {
        const PlacedVertices placed(object);
        for (const scene::Triangle& triangle : object.triangles) {
            append(bytes, std::uint8_t(3));
            for (const std::uint32_t vertex : placed.triangle(triangle)) append(bytes, vertex + first);
        }
        first += std::uint32_t(object.positions.size());
    }
    return bytes;
}

}  // namespace chiaro::exporting
