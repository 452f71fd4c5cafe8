#include "core/scene/mesh.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace chiaro::scene {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

std::uint64_t hashOf(glm::vec3 point) {
    // Adding zero makes -0 and 0 one.
    const glm::uvec3 bits(std::bit_cast<std::uint32_t>(point.x + 0.0f),
                          std::bit_cast<std::uint32_t>(point.y + 0.0f),
                          std::bit_cast<std::uint32_t>(point.z + 0.0f));
    std::uint64_t hash = bits.x * 0x9E3779B97F4A7C15ULL;
    hash = (hash ^ (hash >> 29) ^ bits.y) * 0xBF58476D1CE4E5B9ULL;
    hash = (hash ^ (hash >> 32) ^ bits.z) * 0x94D049BB133111EBULL;
    return hash ^ (hash >> 31);
}

}  // namespace

void BoundsBuilder::addPoint(glm::vec3 point) {
    m_bounds.minimum = m_points.empty() ? point : glm::min(m_bounds.minimum, point);
    m_bounds.maximum = m_points.empty() ? point : glm::max(m_bounds.maximum, point);
    m_points.push_back(point);
}

void BoundsBuilder::addMesh(const Mesh& mesh, const glm::mat4& transform) {
    std::vector<bool> used(mesh.positions.size());
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) used[vertex] = true;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) addPoint(glm::vec3(transform * glm::vec4(mesh.positions[i], 1)));
}

Bounds BoundsBuilder::bounds() const {
    Bounds bounds = m_bounds;
    for (const glm::vec3& point : m_points)
        bounds.radius = std::max(bounds.radius, glm::distance(point, bounds.center()));
    return bounds;
}

Bounds boundsOf(const Mesh& mesh) {
    BoundsBuilder builder;
    builder.addMesh(mesh, glm::mat4(1));
    return builder.bounds();
}

Mesh merged(const std::vector<Mesh>& meshes) {
    Mesh all;
    for (const Mesh& mesh : meshes) {
        const auto base = std::uint32_t(all.positions.size());
        all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
        all.normals.insert(all.normals.end(), mesh.normals.begin(), mesh.normals.end());
        for (const Triangle& t : mesh.triangles)
            all.triangles.push_back({base + t[0], base + t[1], base + t[2]});
    }
    if (all.normals.size() != all.positions.size()) all.normals.clear();
    return all;
}

std::vector<std::uint32_t> weldedIndices(const Mesh& mesh) {
    const std::size_t count = mesh.positions.size();
    const std::size_t mask = std::bit_ceil(std::max<std::size_t>(count * 2, 16)) - 1;
    std::vector<std::uint32_t> table(mask + 1, none);
    std::vector<std::uint32_t> welded(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t slot = hashOf(mesh.positions[i]) & mask;
        while (table[slot] != none && mesh.positions[table[slot]] != mesh.positions[i])
            slot = (slot + 1) & mask;
        if (table[slot] == none) table[slot] = std::uint32_t(i);
        welded[i] = table[slot];
    }
    return welded;
}

}  // namespace chiaro::scene
