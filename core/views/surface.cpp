#include "core/views/surface.h"

#include <algorithm>
#include <utility>

namespace chiaro::views {

Surface::Surface(std::shared_ptr<const scene::Mesh> mesh) : m_mesh(std::move(mesh)) {
    const std::vector<std::uint32_t> welded = scene::weldedIndices(*m_mesh);
    const std::size_t count = m_mesh->triangles.size();
    m_welded.reserve(count);
    m_normals.reserve(count);
    m_areas.reserve(count);
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high(-low);
    for (std::uint32_t face = 0; face < count; ++face) {
        const scene::Triangle& triangle = m_mesh->triangles[face];
        m_welded.push_back({welded[triangle[0]], welded[triangle[1]], welded[triangle[2]]});
        const glm::dvec3 a = corner(face, 0);
        const glm::dvec3 cross = glm::cross(corner(face, 1) - a, corner(face, 2) - a);
        const double length = glm::length(cross);
        m_normals.push_back(length > 0 ? cross / length : glm::dvec3(0));
        m_areas.push_back(length / 2);
        m_totalArea += length / 2;
        if (!(length > 0)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            low = glm::min(low, corner(face, k));
            high = glm::max(high, corner(face, k));
        }
    }
    if (!(m_totalArea > 0)) return;
    m_center = low * 0.5 + high * 0.5;
    for (std::uint32_t face = 0; face < count; ++face)
        for (std::size_t k = 0; k < 3 && m_areas[face] > 0; ++k)
            m_radius = std::max(m_radius, glm::distance(corner(face, k), m_center));
    const glm::dvec3 farthest = glm::max(glm::abs(low), glm::abs(high));
    constexpr double rounding = 0x1p-22;  // four times that of a float
    m_coincidence = 1e-6 * m_radius + rounding * std::max({farthest.x, farthest.y, farthest.z});
}

bool Surface::adjacent(std::uint32_t a, std::uint32_t b) const {
    for (const std::uint32_t corner : m_welded[a])
        if (corner == m_welded[b][0] || corner == m_welded[b][1] || corner == m_welded[b][2]) return true;
    return false;
}

}  // namespace chiaro::views
