#pragma once

#include "core/gradient/gradient.h"
#include "core/synthesis/levels.h"

namespace chiaro::cli {

/// The levels side by side, darkest first, each tiled 2x2 over its section's colour, so that a seam would
/// show.
ColorImage levelSheet(const synthesis::LevelStack& stack, const gradient::Gradient& gradient);

/// Pictures in rows of `columns`, top-left aligned on white, `gap` pixels between them.
ColorImage contactSheet(const std::vector<ColorImage>& pictures, int columns, int gap);

}  // namespace chiaro::cli
