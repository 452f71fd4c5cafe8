#pragma once

#include "core/synthesis/levels.h"

#include <array>
#include <cstdint>
#include <vector>

namespace chiaro::widgets {

/// A level stack as texels of 8 bits a channel: half the memory of half floats, and the format that every
/// OpenGL, software ones included, filters fastest. The range is stretched over the largest difference of the
/// stack, so that a step is at most 1/127 of that (painted strips: under 1/255 of the full range), and zero
/// is met exactly.
struct LevelTexels {
    using Texel = std::array<std::uint8_t, 4>;  ///< RGB; the fourth only keeps texels aligned
    int size = 0;                               ///< a level's side, texels
    int count = 0;                              ///< of levels
    float factor = 0;                           ///< difference = texel / 255 * factor + bias
    float bias = 0;
    std::vector<Texel> texels;  ///< level after level, row after row, top first
};

/// The texels of a stack of equal square levels. Safe from any thread.
LevelTexels levelTexels(const synthesis::LevelStack& stack);

}  // namespace chiaro::widgets
