#pragma once

#include "core/base/task.h"
#include "core/export/placed_surface.h"

#include <array>
#include <vector>

namespace chiaro::exporting {

/// How large an atlas is.
struct AtlasParams {
    int size = 2048;  ///< side, 64..8192 texels
    int padding = 8;  ///< between charts, 0..64 texels
};

/// Where an object's faces lie in the atlas.
struct AtlasFaces {
    std::vector<std::array<glm::vec2, 3>> corners;  ///< texels, x right, y down, a texel's centre at + 0.5
    std::vector<std::uint32_t> chart;  ///< faces of one chart share the places of their common vertices;
                                       ///< a face without area is alone in one
};

/// How well an atlas does its work.
struct AtlasReport {
    std::size_t faces = 0;
    std::size_t charts = 0;  ///< of faces with area
    int padding = 0;         ///< that there was room for
    double coverage = 0;     ///< share of the texels whose centres lie in a chart, in [0, 1]
    double overlap = 0;      ///< share of those that lie inside two faces; 0 but for a mistake
    double densityP5 = 0;    ///< texels a world unit takes: a twentieth of the area has less,
    double densityP95 = 0;   ///< and a twentieth more
};

/// The surface of several objects laid out in one square without overlap, all at one density as far as
/// possible, so that strokes are of one size.
struct Atlas {
    int size = 0;                     ///< side, texels
    std::vector<AtlasFaces> objects;  ///< [i] of the i-th place
    AtlasReport report;
};

/// Lays out every face: charts come from the face groups of the objects' plans (§4.3, see makeCharts), each
/// of them connected, and are as large as the atlas has room for; where so many are needed that most of it
/// would be padding, that shrinks. A face without area lies in one point, of a neighbour if it has one.
/// The transforms are invertible. Deterministic for any number of threads. Throws Error when a parameter is
/// out of range or even a texel a chart is too much, Cancelled.
Atlas makeAtlas(const std::vector<PlannedPlace>& places, const AtlasParams& params, const Task& task = {});

}  // namespace chiaro::exporting
