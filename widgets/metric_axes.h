#pragma once

#include "core/metrics/line_chart.h"

class QAbstractAxis;

namespace chiaro::widgets {

/// The largest value of any curve, its standard error included; 0 without curves.
double mostOf(const metrics::LineChart& chart);

/// Axes for a chart with its ticks and labels, and with a little room around its curves. The caller owns
/// them.
QAbstractAxis* horizontalAxis(const metrics::LineChart& chart);
/// From the chart's least value, or 0, to a round one that is neither below its curves nor below `atLeast`.
QAbstractAxis* verticalAxis(const metrics::LineChart& chart, double atLeast);

}  // namespace chiaro::widgets
