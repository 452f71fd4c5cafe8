#include "core/methods/level_texels.h"

#include <algorithm>

namespace chiaro::methods {

LevelTexels levelTexels(const synthesis::LevelStack& stack) {
    LevelTexels result;
    result.count = int(stack.levels.size());
    result.size = stack.levels.front().width();
    float largest = 0;
    for (const ColorImage& level : stack.levels) largest = std::max(largest, largestDifference(level));
    result.range = DifferenceRange::of(largest);
    const std::size_t levelTexelCount = stack.levels.front().pixelCount();
    result.texels.resize(levelTexelCount * stack.levels.size());
    for (std::size_t i = 0; i < stack.levels.size(); ++i)
        encodeDifferences(stack.levels[i], result.range, result.texels.data() + i * levelTexelCount);
    return result;
}

}  // namespace chiaro::methods
