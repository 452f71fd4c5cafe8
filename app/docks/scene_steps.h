#pragma once

#include "app/meshes.h"

#include <algorithm>
#include <cmath>

namespace chiaro::app {

/// The radius of what is shown; 1 where nothing is.
inline float sceneRadius(const Meshes& meshes) {
    const float radius = scene::boundsOf(meshes.scene()).radius;
    return radius > 0 ? radius : 1;
}

/// How far an arrow key moves a thing of the scene: 1, 2 or 5 times a power of ten, about a fiftieth of it.
inline double stepIn(const Meshes& meshes) {
    const double wanted = std::max(double(sceneRadius(meshes)), 1e-6) / 50;
    const double power = std::pow(10, std::floor(std::log10(wanted)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= wanted) return step * power;
    return 10 * power;
}

}  // namespace chiaro::app
