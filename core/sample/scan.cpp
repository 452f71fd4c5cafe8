#include "core/base/color.h"
#include "core/base/image_io.h"
#include "core/sample/strip.h"

#include <algorithm>

namespace chiaro::sample {

namespace {

/// Paper shows through what the scan doesn't cover, in the light that the scan's values stand for.
glm::vec3 onWhitePaper(glm::vec3 color, float coverage) {
    coverage = std::clamp(coverage, 0.0f, 1.0f);
    return coverage == 1 ? color : color * coverage + glm::vec3(1 - coverage);
}

}  // namespace

ColorImage readScan(const std::filesystem::path& path) {
    const DecodedImage decoded = readImage(path);
    const bool hasColor = decoded.channels >= 3;
    const bool hasCoverage = decoded.channels % 2 == 0;
    ColorImage scan(decoded.width, decoded.height);
    const float* from = decoded.values.data();
    for (glm::vec3& pixel : scan.pixels()) {
        pixel = hasColor ? glm::vec3(from[0], from[1], from[2]) : glm::vec3(from[0]);
        from += decoded.channels;
        if (hasCoverage) pixel = onWhitePaper(pixel, from[-1]);
        if (decoded.linear) pixel = srgbFromLinear(pixel);
        pixel = glm::clamp(pixel, 0.0f, 1.0f);
    }
    return scan;
}

}  // namespace chiaro::sample
