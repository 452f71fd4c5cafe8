#pragma once

#include "core/methods/difference_texels.h"
#include "core/synthesis/levels.h"

#include <vector>

namespace chiaro::methods {

/// A level stack as texels.
struct LevelTexels {
    int size = 0;   ///< a level's side, texels
    int count = 0;  ///< of levels
    DifferenceRange range;
    std::vector<DifferenceTexel> texels;  ///< level after level, row after row, top first
};

/// The texels of a stack of equal square levels. Safe from any thread.
LevelTexels levelTexels(const synthesis::LevelStack& stack);

}  // namespace chiaro::methods
