#pragma once

#include "core/base/task.h"
#include "core/export/charts.h"

#include <optional>

namespace chiaro::exporting {

/// Where charts lie in an atlas.
struct ChartPacking {
    double scale = 1;                 ///< texels a world unit
    int padding = 0;                  ///< texels between any two charts
    std::vector<glm::dvec2> origins;  ///< of each chart's top left corner, texels
};

/// Packs charts into a square, as large as there is room for, all by the same scale. Where that is mostly
/// padding, this is halved while it is 4 texels or more; where charts don't fit at a texel each, until they
/// do. Empty when even no padding helps. Throws Cancelled.
std::optional<ChartPacking> packCharts(const std::vector<Chart>& charts, int size, int padding,
                                       const Task& task = {});

}  // namespace chiaro::exporting
