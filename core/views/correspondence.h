#pragma once

#include "core/views/planning.h"

#include <optional>
#include <vector>

namespace chiaro::views {

/// Faces that are in both groups, ascending.
std::vector<std::uint32_t> sharedFaces(const FaceGroup& a, const FaceGroup& b);

/// An affine map of the plane: the 2 x 3 matrix (linear | offset).
struct AffineMap {
    glm::dmat2 linear{1};
    glm::dvec2 offset{0};
    glm::dvec2 operator()(const glm::dvec2& point) const { return linear * point + offset; }
};

/// The map from where a face lies in one view's map to where it lies in the other's, both in texels (x right,
/// y down), corners to corners (§4.3.5). Between orthographic views it is exact for the whole face. Empty
/// when the face is edge-on, or nearly so, in the view that it maps from: its texels there say nothing.
std::optional<AffineMap> triangleMap(const Surface& surface, std::uint32_t face, const Projector& from,
                                     const Projector& to);

}  // namespace chiaro::views
