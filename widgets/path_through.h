#pragma once

#include "core/gradient/color_path.h"

#include <vector>

namespace chiaro::widgets {

/// A path of at most `maximumStops` stops, in RGB, that stays close to these colours: where an artist goes on
/// from a strip's own gradient. Two colours at least.
gradient::ColorPath pathThrough(const std::vector<glm::vec3>& colors, int maximumStops = 7);

}  // namespace chiaro::widgets
