#pragma once

#include "core/base/image.h"
#include "core/views/occluders.h"
#include "core/views/planning.h"

namespace chiaro::views {

/// Stands for "no face".
inline constexpr std::uint32_t noFace = 0xFFFFFFFF;

/// What a view's map shows at its texels' centres, top row first.
struct FaceMap {
    Image<std::uint32_t> face;  ///< of the surface; noFace where nothing was drawn
    ScalarImage depth;  ///< in front of the eye, units of the object; infinity where nothing was drawn
};

/// Draws a group's faces, and nothing else, into its view's map of size x size texels. Where adjacent faces
/// overlap, the nearest one shows; at equal depth, the first. Thread-safe.
FaceMap drawGroup(const Surface& surface, const FaceGroup& group);

/// Draws any faces (`drawn` not 0) as a view sees them, both sides.
FaceMap drawFaces(const Surface& surface, const View& view, const FaceMask& drawn);

}  // namespace chiaro::views
