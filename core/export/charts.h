#pragma once

#include "core/base/task.h"
#include "core/export/flat_faces.h"
#include "core/export/placed_surface.h"

namespace chiaro::exporting {

/// A connected part of an object's surface laid flat: no two of its faces overlap, and none is seen at a
/// steep angle. As large as the surface is, so that all charts have one density.
struct Chart {
    std::size_t object = 0;
    std::vector<std::uint32_t> faces;
    std::vector<FlatFace> corners;  ///< of each face, in its order; world units, x right, y down, from (0, 0)
    glm::dvec2 size{0};             ///< where they end
};

/// Lays all faces with area of an object flat. A chart shows faces of one group of the plan (see chartGroups)
/// along their mean normal, or else from that group's view; what would overlap there, or be seen too
/// steeply, gets charts of its own. Deterministic. Throws Cancelled.
std::vector<Chart> makeCharts(const PlacedSurface& surface, std::size_t object, const Task& task = {});

}  // namespace chiaro::exporting
