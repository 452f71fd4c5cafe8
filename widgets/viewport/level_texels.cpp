#include "widgets/viewport/level_texels.h"

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr float zero = 128;   // the texel of no difference
constexpr float reach = 127;  // texels from there to the largest difference, either way

float largestDifference(const ColorImage& level) {
    float largest = 0;
    for (const glm::vec3& difference : level.pixels())
        largest = std::max({largest, std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)});
    return largest;
}

LevelTexels::Texel* encode(const ColorImage& level, float scale, LevelTexels::Texel* texels) {
    for (const glm::vec3& difference : level.pixels()) {
        const glm::vec3 scaled = difference * scale + (zero + 0.5f);
        *texels++ = {std::uint8_t(scaled.r), std::uint8_t(scaled.g), std::uint8_t(scaled.b), 255};
    }
    return texels;
}

}  // namespace

LevelTexels levelTexels(const synthesis::LevelStack& stack) {
    LevelTexels result;
    result.count = int(stack.levels.size());
    result.size = stack.levels.front().width();
    float largest = 0;
    for (const ColorImage& level : stack.levels) largest = std::max(largest, largestDifference(level));
    const float range = std::max(largest, 1.0f / 255);
    result.factor = 255 * range / reach;
    result.bias = -zero * range / reach;
    result.texels.resize(stack.levels.front().pixelCount() * stack.levels.size());
    LevelTexels::Texel* texels = result.texels.data();
    for (const ColorImage& level : stack.levels) texels = encode(level, reach / range, texels);
    return result;
}

}  // namespace chiaro::widgets
