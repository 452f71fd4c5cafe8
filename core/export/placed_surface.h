#pragma once

#include "core/methods/view_textures.h"
#include "core/scene/scene.h"

#include <memory>

namespace chiaro::exporting {

/// An object of a scene with the views that paint it.
struct PlannedPlace {
    std::shared_ptr<const methods::PlannedObject> planned;
    glm::mat4 transform{1};  ///< object to world
};

/// An object's faces at their place in the world, whatever its topology. Immutable; the planned object must
/// outlive it.
class PlacedSurface {
public:
    explicit PlacedSurface(const PlannedPlace& place);

    const methods::PlannedObject& planned() const { return m_planned; }
    std::size_t faceCount() const { return m_planned.surface.faceCount(); }
    const glm::dvec3& corner(std::uint32_t face, std::size_t k) const {
        return m_points[m_planned.surface.mesh().triangles[face][k]];
    }
    /// Half its length is the face's area, it points to where the face's front looks; 0 for a face without
    /// area in the object's own space.
    const glm::dvec3& cross(std::uint32_t face) const { return m_crosses[face]; }
    /// In squared world units.
    double area(std::uint32_t face) const { return glm::length(m_crosses[face]) / 2; }
    /// Whether corners that run counter-clockwise seen from the front of a face run clockwise in the world.
    bool isMirrored() const { return glm::determinant(m_linear) < 0; }
    /// Unit vector from the object towards the eye of one of its views.
    glm::dvec3 towardsEye(std::size_t group) const;
    /// Faces that share an edge with this one, equal positions being one vertex.
    std::span<const std::uint32_t> neighbours(std::uint32_t face) const {
        return {m_neighbours.data() + m_first[face], m_first[face + 1] - m_first[face]};
    }

private:
    void findNeighbours();

    const methods::PlannedObject& m_planned;
    glm::dmat3 m_linear;
    std::vector<glm::dvec3> m_points;
    std::vector<glm::dvec3> m_crosses;
    std::vector<std::size_t> m_first;
    std::vector<std::uint32_t> m_neighbours;
};

}  // namespace chiaro::exporting
