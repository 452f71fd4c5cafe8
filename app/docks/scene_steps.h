#pragma once

#include "core/scene/scene.h"

#include <algorithm>
#include <cmath>

namespace chiaro::app {

/// How far an arrow key moves a thing of a scene of this radius: 1, 2 or 5 times a power of ten, about a
/// fiftieth of it.
inline double stepFor(float radius) {
    const double wanted = std::max(double(radius), 1e-6) / 50;
    const double power = std::pow(10, std::floor(std::log10(wanted)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= wanted) return step * power;
    return 10 * power;
}

}  // namespace chiaro::app
