#pragma once

#include "core/gradient/color_path.h"

#include <span>

namespace chiaro::gradient {

/// A colour path worth starting from.
struct ColorPreset {
    const char* name;  ///< English; translators find it in the context ColorPreset
    ColorPath path;
};

/// Dark to light, each named after the pigments or the medium that it recalls.
std::span<const ColorPreset> colorPresets();

}  // namespace chiaro::gradient
