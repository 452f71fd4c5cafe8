#pragma once

#include "core/base/image.h"
#include "core/views/planning.h"

namespace chiaro::views {

/// What GroupMap's texels hold where no face of the group lies.
inline constexpr std::uint32_t noFace = 0xFFFFFFFF;

/// Draws a group's faces, and nothing else, into its view's map: size x size texels, top row first, each with
/// the face whose projection holds the texel's centre, else noFace. Where adjacent faces overlap, the nearest
/// one; at equal depth, the first. Thread-safe.
Image<std::uint32_t> drawGroup(const Surface& surface, const FaceGroup& group);

/// Draws any faces (`drawn`, one value a face, not 0 for those to draw) as a view sees them, both sides.
Image<std::uint32_t> drawFaces(const Surface& surface, const View& view,
                               const std::vector<std::uint8_t>& drawn);

}  // namespace chiaro::views
