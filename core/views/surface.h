#pragma once

#include "core/scene/mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace chiaro::views {

/// What planning and visibility need to know of a mesh, worked out once: which faces have area, where they
/// face, and which share a vertex. Any topology; object space. Immutable, so any number of threads may read
/// it.
class Surface {
public:
    /// `mesh` has finite positions and indices within them.
    explicit Surface(std::shared_ptr<const scene::Mesh> mesh);

    const scene::Mesh& mesh() const { return *m_mesh; }
    std::size_t faceCount() const { return m_areas.size(); }
    glm::dvec3 corner(std::uint32_t face, std::size_t k) const {
        return glm::dvec3(m_mesh->positions[m_mesh->triangles[face][k]]);
    }
    glm::dvec3 centroid(std::uint32_t face) const {
        return (corner(face, 0) + corner(face, 1) + corner(face, 2)) / 3.0;
    }
    /// Unit, on the side from which the corners run counter-clockwise; 0 for a face without area.
    const glm::dvec3& normal(std::uint32_t face) const { return m_normals[face]; }
    /// In squared units of the mesh; 0 when the corners lie on a line.
    double area(std::uint32_t face) const { return m_areas[face]; }
    double totalArea() const { return m_totalArea; }
    /// Whether two faces share a vertex, equal positions being one vertex. A face is adjacent to itself.
    bool adjacent(std::uint32_t a, std::uint32_t b) const;

    /// Centre of the box around all faces with area, and the radius of the sphere around it that holds them;
    /// the radius is 0 only when no face has area.
    const glm::dvec3& center() const { return m_center; }
    double radius() const { return m_radius; }
    /// Faces nearer to each other than this are coincident: a little more than what positions are rounded to.
    double coincidence() const { return m_coincidence; }

private:
    std::shared_ptr<const scene::Mesh> m_mesh;
    std::vector<scene::Triangle> m_welded;
    std::vector<glm::dvec3> m_normals;
    std::vector<double> m_areas;
    double m_totalArea = 0;
    glm::dvec3 m_center{0};
    double m_radius = 0;
    double m_coincidence = 0;
};

}  // namespace chiaro::views
