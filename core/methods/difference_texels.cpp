#include "core/methods/difference_texels.h"

#include <algorithm>

namespace chiaro::methods {

namespace {

constexpr float zero = noDifference[0];
constexpr float reach = 127;  // texels from there to the largest difference, either way

}  // namespace

DifferenceRange DifferenceRange::of(float largest) {
    const float range = std::max(largest, 1.0f / 255);
    return {255 * range / reach, -zero * range / reach};
}

glm::vec3 DifferenceRange::difference(DifferenceTexel texel) const {
    return glm::vec3(texel[0], texel[1], texel[2]) * (factor / 255) + bias;
}

float largestDifference(const ColorImage& differences) {
    float largest = 0;
    for (const glm::vec3& difference : differences.pixels())
        largest = std::max({largest, std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)});
    return largest;
}

void encodeDifferences(const ColorImage& differences, const DifferenceRange& range, DifferenceTexel* texels) {
    const float scale = 255 / range.factor;
    for (const glm::vec3& difference : differences.pixels()) {
        const glm::vec3 scaled = difference * scale + (zero + 0.5f);
        *texels++ = {std::uint8_t(scaled.r), std::uint8_t(scaled.g), std::uint8_t(scaled.b), 255};
    }
}

}  // namespace chiaro::methods
