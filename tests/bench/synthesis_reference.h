#pragma once

#include "core/synthesis/levels.h"

namespace chiaro::bench {

/// A painted strip made from numbers: oriented strokes over a gradient, with paper grain.
struct GeneratedPaint {
    ColorImage strip;
    std::vector<glm::vec3> gradient;
};
GeneratedPaint generatePaint(int width, int height);

/// The same quilting with the search that OpenCV users write: cv::matchTemplate(TM_SQDIFF) in float, one call
/// a rectangle of the overlap. The baseline that speed and overlap error are compared with. One thread.
synthesis::QuiltResult quiltWithMatchTemplate(const synthesis::QuiltTask& task,
                                              const synthesis::QuiltParams& params);

/// Level stack of the baseline, levels in parallel, with gradient base and seam tiling.
synthesis::QuiltReport levelsWithMatchTemplate(const GeneratedPaint& paint,
                                               const synthesis::LevelParams& params);

/// A 512 x 512 frame of a ball: light falls off from the middle, each block may use 256 columns of the strip
/// around its light (§4.1).
synthesis::QuiltTask ballFrame(const ColorImage& texture, int size);

}  // namespace chiaro::bench
