#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace chiaro::exporting {

/// Corners in the plane, counter-clockwise (x right, y up).
using FlatFace = std::array<glm::dvec2, 3>;

/// Faces in the plane of which no two overlap; they may touch. A grid keeps the question local.
class FlatFaces {
public:
    /// For about `count` faces between `low` and `high`.
    FlatFaces(const glm::dvec2& low, const glm::dvec2& high, std::size_t count);
    /// Adds a face; false, and nothing happens, when it overlaps one that is there by more than rounding.
    bool add(const FlatFace& face);

private:
    template <class Visit>
    bool anyCell(const FlatFace& face, Visit visit);
    bool overlap(const FlatFace& a, const FlatFace& b) const;
    bool separates(const FlatFace& a, const FlatFace& b) const;

    glm::dvec2 m_low;
    double m_cell;       ///< a cell's side
    double m_tolerance;  ///< faces may share a strip as wide as this
    glm::ivec2 m_cells;
    std::vector<std::vector<std::uint32_t>> m_facesOfCells;
    std::vector<FlatFace> m_faces;
};

}  // namespace chiaro::exporting
