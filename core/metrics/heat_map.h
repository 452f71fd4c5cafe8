#pragma once

#include "core/base/image.h"

namespace chiaro::metrics {

/// Values as colours, dark for the least to bright for the most, on a grey ground where they are negative or
/// NaN: nothing was measured there.
ColorImage heatMap(const ScalarImage& values, float least, float most);

/// The same with a bar to its right, as high as the picture, that tells which value a colour stands for.
ColorImage heatMapWithBar(const ScalarImage& values, float least, float most);

/// A round number that few of the values (one in 200 at most) exceed: where a heat map's colours may end.
/// 0.01 when nothing was measured or all is 0.
float heatMapEnd(const ScalarImage& values);

/// Where each pixel's best match lies in a source: its hue tells x from left (blue) to right (red), its
/// brightness y from top (bright) to bottom; grey where it is negative.
ColorImage matchMap(const Image<glm::i16vec2>& best, int sourceWidth, int sourceHeight);

}  // namespace chiaro::metrics
