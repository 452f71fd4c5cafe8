#pragma once

#include "core/metrics/line_chart.h"
#include "core/metrics/study.h"
#include "core/project/comparison.h"

#include <filesystem>
#include <string>
#include <vector>

namespace chiaro::app {

/// Figures as they go to a file: as a table in two formats, or as charts. Empty where there are none.
struct MetricSheet {
    std::string csv;
    std::string markdown;
    std::vector<metrics::LineChart> charts;
    int columns = 1;  ///< of charts; those of a row share the scale of y
};

/// What frameCharts() gives, in their order.
struct FrameChart {
    const char* label;    ///< of the switch, to be translated
    const char* tooltip;  ///< of the switch, to be translated
    metrics::Estimate project::MeasuredErrors::*error;
};
std::span<const FrameChart> frameChartKinds();

/// A chart an error, a curve a method.
std::vector<metrics::LineChart> frameCharts(const std::vector<project::MethodMeasure>& table);
/// A chart a block size, a curve a texture.
std::vector<metrics::LineChart> studyCharts(const std::vector<metrics::StudyPoint>& points,
                                            metrics::Distortion distortion);

/// By the extension: .csv, .md, .svg, or .png at twice the size of the charts. Atomically. Throws Error when
/// it is another, or when the sheet has nothing of that kind.
void writeSheet(const std::filesystem::path& path, const MetricSheet& sheet);

}  // namespace chiaro::app
