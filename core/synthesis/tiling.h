#pragma once

#include "core/base/image.h"

namespace chiaro::synthesis {

/// The report's tiling (§4.2): a square picture blended with itself rolled by half its side, by a circular
/// mask, so that it repeats without a seam. Blurs where the two mix. Any side of at least 2 px.
ColorImage tiledByMask(const ColorImage& texture);

}  // namespace chiaro::synthesis
