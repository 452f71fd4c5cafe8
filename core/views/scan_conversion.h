#pragma once

#include "core/views/view.h"

#include <array>
#include <optional>
#include <vector>

namespace chiaro::views {

/// A rectangle of texels, from `low` up to but without `high`.
struct TexelBox {
    glm::ivec2 low{0};
    glm::ivec2 high{0};
    bool empty() const { return low.x >= high.x || low.y >= high.y; }
};

/// All positions of a mesh as a view's map sees them.
class ProjectedMesh {
public:
    ProjectedMesh(const Surface& surface, const View& view);

    const Surface& surface() const { return m_surface; }
    const Projector& projector() const { return m_projector; }
    int size() const { return m_size; }
    /// Map position of a corner, texels, and its depth as it interpolates across the map (see depthOf).
    const glm::dvec3& corner(std::uint32_t face, std::size_t k) const {
        return m_points[m_surface.mesh().triangles[face][k]];
    }
    /// The texels whose centres the face's box holds.
    TexelBox boxOf(std::uint32_t face) const;
    /// Depth is affine in the map for an orthographic view, its inverse for one in perspective.
    double depthOf(double interpolated) const {
        return m_projector.perspective() ? 1 / interpolated : interpolated;
    }
    /// Units of the object that a texel is wide at this depth.
    double texelSize(double depth) const { return m_texel * (m_projector.perspective() ? depth : 1); }

private:
    const Surface& m_surface;
    Projector m_projector;
    int m_size;
    double m_texel;
    std::vector<glm::dvec3> m_points;
};

/// A centre this near to a face's edge, in texels, still counts as covered: what rasterisers in single
/// precision may see differently is treated with caution.
inline constexpr double edgeTolerance = 1e-4;

/// Finds the texel centres that one face covers.
class FaceScan {
public:
    /// Empty for a face that the view sees edge-on: it covers nothing.
    static std::optional<FaceScan> of(const ProjectedMesh& projected, std::uint32_t face);

    /// Calls visit(x, y, depth) for each texel in the box whose centre the face covers, in raster order.
    template <class Visit>
    void scan(const TexelBox& box, Visit visit) const {
        for (int y = box.low.y; y < box.high.y; ++y)
            for (int x = box.low.x; x < box.high.x; ++x) {
                const glm::dvec2 centre(x + 0.5, y + 0.5);
                if (covers(centre)) visit(x, y, depthAt(centre));
            }
    }

private:
    /// Distance to an edge, texels, positive inside: normal . point + offset.
    struct Edge {
        glm::dvec2 normal;
        double offset;
    };

    bool covers(const glm::dvec2& point) const {
        for (const Edge& edge : m_edges)
            if (glm::dot(edge.normal, point) + edge.offset < -edgeTolerance) return false;
        return true;
    }
    double depthAt(const glm::dvec2& point) const {
        const double value = m_origin.z + glm::dot(m_slope, point - glm::dvec2(m_origin));
        return m_projected->depthOf(glm::clamp(value, m_lowest, m_highest));
    }

    const ProjectedMesh* m_projected = nullptr;
    std::array<Edge, 3> m_edges;
    glm::dvec3 m_origin;
    glm::dvec2 m_slope;  ///< of the interpolated depth, a texel
    double m_lowest = 0;
    double m_highest = 0;
};

}  // namespace chiaro::views
