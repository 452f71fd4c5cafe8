#pragma once

#include "core/base/image.h"
#include "core/base/random.h"

namespace chiaro::test {

/// Colours that the search holds exactly: whole multiples of 1/63 in [-1, 1], both ends among them.
inline ColorImage exactNoise(int width, int height, std::uint64_t seed) {
    ColorImage image(width, height);
    Random random(seed);
    for (glm::vec3& color : image.pixels())
        for (int c = 0; c < 3; ++c) color[c] = (float(random.below(127)) - 63) / 63;
    image(0, 0) = glm::vec3(-1);
    image(width - 1, height - 1) = glm::vec3(1);
    return image;
}

/// Smooth waves with a little noise: neighbouring pixels are alike, as in paint.
inline ColorImage waves(int width, int height, std::uint64_t seed) {
    ColorImage image(width, height);
    Random random(seed);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float a = std::sin(0.31f * float(x) + 0.17f * float(y)),
                        b = std::sin(0.23f * float(y) - 0.11f * float(x));
            image(x, y) = 0.3f * glm::vec3(a, b, a * b) + 0.05f * float(random.uniform());
        }
    return image;
}

}  // namespace chiaro::test
