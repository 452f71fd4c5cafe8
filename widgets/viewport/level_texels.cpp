#include "widgets/viewport/level_texels.h"

#include <QtConcurrent>

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

void encode(const ColorImage& level, float scale, LevelTexels::Texel* texels) {
    for (const glm::vec3& difference : level.pixels()) {
        const glm::vec3 scaled = difference * scale + (zero + 0.5f);
        *texels++ = {std::uint8_t(scaled.r), std::uint8_t(scaled.g), std::uint8_t(scaled.b), 255};
    }
}

}  // namespace

LevelTexels levelTexels(const synthesis::LevelStack& stack) {
    LevelTexels result;
    result.count = int(stack.levels.size());
    result.size = stack.levels.front().width();
    const float largest = QtConcurrent::blockingMappedReduced<float>(
        stack.levels, largestDifference, [](float& total, float one) { total = std::max(total, one); });
    const float range = std::max(largest, 1.0f / 255);
    result.factor = 255 * range / reach;
    result.bias = -zero * range / reach;
    const std::size_t perLevel = stack.levels.front().pixelCount();
    result.texels.resize(perLevel * stack.levels.size());
    QtConcurrent::blockingMap(stack.levels, [&](const ColorImage& level) {
        const auto index = std::size_t(&level - stack.levels.data());
        encode(level, reach / range, result.texels.data() + index * perLevel);
    });
    return result;
}

}  // namespace chiaro::widgets
