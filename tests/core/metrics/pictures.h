#pragma once

#include "core/base/random.h"
#include "core/metrics/descriptor.h"

namespace chiaro::test {

/// Every pixel another colour.
inline ColorImage speckled(int width, int height, std::uint64_t seed) {
    Random random(seed);
    ColorImage picture(width, height);
    for (glm::vec3& pixel : picture.pixels())
        for (int c = 0; c < 3; ++c) pixel[c] = float(random.below(256)) / 255.0f;
    return picture;
}

/// Rough blotches: few colours, so that many blocks are equally far from each other.
inline ColorImage blotched(int width, int height, std::uint64_t seed) {
    Random random(seed);
    ColorImage picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture(x, y) = x % 3 && x > 0 ? picture(x - 1, y) : glm::vec3(float(random.below(3)) / 2.0f);
    return picture;
}

inline ColorImage part(const ColorImage& picture, int left, int top, int width, int height) {
    ColorImage result(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) result(x, y) = picture(left + x, top + y);
    return result;
}

}  // namespace chiaro::test
