#pragma once

#include "core/base/image.h"

#include <optional>
#include <string>
#include <vector>

namespace chiaro::metrics {

/// Charts of curves as a file for browsers and text processors (SVG), and as a picture.

struct ChartPoint {
    double x = 0, y = 0;
    double error = 0;  ///< drawn as a bar of this length up and down; 0 draws none
};

struct Series {
    std::string name;
    std::vector<ChartPoint> points;  ///< in order of x
};

struct Axis {
    std::string label;
    std::optional<double> least;  ///< where it begins; without it at the least value
    std::vector<double> ticks;    ///< without them round numbers
    bool logarithmic = false;     ///< equal factors are equally far apart; values are positive
};

struct LineChart {
    std::string title;
    Axis x, y;
    std::vector<Series> series;
};

/// The charts in rows of `columns`, row by row; those of a row share the range of their y axes. Names may
/// hold any text. Throws nothing for charts without points: they stay empty.
std::string svgOf(const std::vector<LineChart>& charts, int columns);

/// The same as a picture of twice the size, display-referred RGB in [0, 1]. Its letters are ASCII alone:
/// others become question marks.
ColorImage pictureOf(const std::vector<LineChart>& charts, int columns);

}  // namespace chiaro::metrics
