#pragma once

#include "core/base/image.h"

namespace chiaro::synthesis {

/// What lies under a pixel of a block that is about to be placed.
enum class Under : std::uint8_t {
    Nothing,  ///< nothing yet: takes the block's pixel
    Texture,  ///< a pixel that may stay or be replaced
    Outside   ///< not part of the picture: a cut through it costs nothing
};

/// Where the texture that is there stays (1) and where the block replaces it (0).
///
/// From each of the four sides on which texture reaches into the block, a path of least error runs along the
/// side by dynamic programming (Efros and Freeman 2001), one pixel to the side a step at most, or as far as
/// the texture's own edge jumps; what lies before it stays. Texture more than `reach` pixels before the free
/// pixels stays whole, and so does texture that no side reaches, such as an island. `error` is the squared
/// difference of block and texture, of the size of `under`; it matters only where there is texture. Ties go
/// to the path nearer the side.
Image<std::uint8_t> boundaryCut(const Image<Under>& under, const ScalarImage& error, int reach);

}  // namespace chiaro::synthesis
