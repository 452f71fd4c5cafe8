#pragma once

#include "core/base/image.h"

#include <array>
#include <cstdint>

namespace chiaro::methods {

/// A difference RGB in 8 bits a channel; the fourth only keeps texels aligned.
using DifferenceTexel = std::array<std::uint8_t, 4>;

/// The texel of no difference, whatever the range.
inline constexpr DifferenceTexel noDifference{128, 128, 128, 255};

/// How differences become texels of 8 bits: half the memory of half floats, and the format that every OpenGL,
/// software ones included, filters fastest. The range is stretched over the largest difference, so that a
/// step is at most 1/127 of that (painted strips: under 1/255 of the full range), and zero is met exactly.
struct DifferenceRange {
    float factor = 0;  ///< difference = texel / 255 * factor + bias
    float bias = 0;

    /// For differences whose channels lie within -largest and largest.
    static DifferenceRange of(float largest);
    glm::vec3 difference(DifferenceTexel texel) const;
};

/// The largest channel, either way.
float largestDifference(const ColorImage& differences);
/// Texels of a picture whose differences lie within the range that `range` was made for.
void encodeDifferences(const ColorImage& differences, const DifferenceRange& range, DifferenceTexel* texels);

}  // namespace chiaro::methods
