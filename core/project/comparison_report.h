#pragma once

#include "core/project/comparison.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace chiaro::project {

/// One row of the table in which methods are compared (§5).
struct ComparedError {
    const char* name;  ///< "Texture similarity"
    metrics::Estimate MeasuredErrors::*measured;
};
std::span<const ComparedError> comparedErrors();

/// What the report itself found for a method; nothing where it gives no number: it tells of object-space
/// coherence and of the mean absolute shading error in words only.
std::optional<double> reportedError(const ComparedError& error, std::string_view method);

/// The table with standard errors, the report's own figures beside ours.
std::string comparisonMarkdown(const std::vector<MethodMeasure>& table);
/// Rows `measure,method,error,standard_error,pixels,report` under a header.
std::string comparisonCsv(const std::vector<MethodMeasure>& table);
/// Rows `frame,measure,method,error,standard_error,pixels` under a header; none where nothing was measured.
std::string framesCsv(const std::vector<MethodMeasure>& table);

}  // namespace chiaro::project
