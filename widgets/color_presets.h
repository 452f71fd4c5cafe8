#pragma once

#include "core/gradient/color_path.h"

#include <span>

namespace chiaro::widgets {

/// A colour path worth starting from.
struct ColorPreset {
    const char* name;
    gradient::ColorPath path;
};

/// Dark to light, each named after the pigments or the medium that it recalls.
std::span<const ColorPreset> colorPresets();

/// A path of at most `maximumStops` stops, in RGB, that stays close to these colours: where an artist goes on
/// from a strip's own gradient. Two colours at least.
gradient::ColorPath pathThrough(const std::vector<glm::vec3>& colors, int maximumStops = 7);

}  // namespace chiaro::widgets
