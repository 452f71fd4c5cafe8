#include "core/views/scan_conversion.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace chiaro::views {

ProjectedMesh::ProjectedMesh(const Surface& surface, const View& view)
    : m_surface(surface),
      m_projector(view),
      m_size(view.size),
      m_texel(1 / view.texelsPerUnit()),
      m_points(surface.mesh().positions.size()) {
    if (m_projector.perspective()) m_texel /= view.eyeDistance;
    constexpr std::size_t chunk = 4096;
    tbb::parallel_for(std::size_t(0), (m_points.size() + chunk - 1) / chunk, [&](std::size_t c) {
        for (std::size_t i = c * chunk; i < std::min((c + 1) * chunk, m_points.size()); ++i) {
            glm::dvec3& point = m_points[i] = m_projector.project(glm::dvec3(surface.mesh().positions[i]));
            if (m_projector.perspective()) point.z = 1 / point.z;
        }
    });
}

TexelBox ProjectedMesh::boxOf(std::uint32_t face) const {
    const glm::dvec2 a(corner(face, 0));
    const glm::dvec2 b(corner(face, 1));
    const glm::dvec2 c(corner(face, 2));
    const glm::dvec2 low = glm::ceil(glm::min(glm::min(a, b), c) - 0.5 - edgeTolerance);
    const glm::dvec2 high = glm::floor(glm::max(glm::max(a, b), c) - 0.5 + edgeTolerance) + 1.0;
    const glm::dvec2 corner(m_size);
    return {glm::ivec2(glm::clamp(low, glm::dvec2(0), corner)),
            glm::ivec2(glm::clamp(high, glm::dvec2(0), corner))};
}

std::optional<FaceScan> FaceScan::of(const ProjectedMesh& projected, std::uint32_t face) {
    std::array<glm::dvec3, 3> corners{projected.corner(face, 0), projected.corner(face, 1),
                                      projected.corner(face, 2)};
    const glm::dvec3 ab = corners[1] - corners[0];
    const glm::dvec3 ac = corners[2] - corners[0];
    const double area = ab.x * ac.y - ab.y * ac.x;
    if (!(std::abs(area) > 1e-9)) return {};
    FaceScan scan;
    scan.m_projected = &projected;
    scan.m_origin = corners[0];
    scan.m_slope = glm::dvec2(ab.z * ac.y - ac.z * ab.y, ac.z * ab.x - ab.z * ac.x) / area;
    scan.m_lowest = std::min({corners[0].z, corners[1].z, corners[2].z});
    scan.m_highest = std::max({corners[0].z, corners[1].z, corners[2].z});
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 from(corners[k]);
        const glm::dvec2 along = glm::dvec2(corners[(k + 1) % 3]) - from;
        const glm::dvec2 normal =
            glm::dvec2(-along.y, along.x) * (std::copysign(1, area) / glm::length(along));
        scan.m_edges[k] = {normal, -glm::dot(normal, from)};
    }
    return scan;
}

}  // namespace chiaro::views
