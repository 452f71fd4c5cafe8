#pragma once

#include "core/metrics/line_chart.h"
#include "tests/bench/page/results.h"

namespace chiaro::bench {

/// How a figure grows: a chart and what it says in words.
struct Curves {
    std::string file;  ///< its picture's name
    metrics::LineChart chart;
    std::string words;
};

/// The scaling curves that there are results for.
std::vector<Curves> scalingCurves(const Results& results);

}  // namespace chiaro::bench
