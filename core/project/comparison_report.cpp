#include "core/project/comparison_report.h"

#include "core/project/render_method.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>

namespace chiaro::project {

namespace {

using metrics::Estimate;

/// The report's table in §5.
struct Reported {
    const char* method;
    double similarity, shading, temporal;
};
constexpr std::array<Reported, 3> reported{{{"image-based", 0.07539, 0.00536, 0.00297},
                                            {"view-aligned", 0.08048, 0.00521, 0.00016},
                                            {"view-dependent", 0.10197, 0.00582, 0.00547}}};

struct Row {
    ComparedError error;
    double Reported::*reported;  ///< null where the report gives no number
};
constexpr std::array<Row, 5> rows{
    {{{"Texture similarity", &MeasuredErrors::similarity}, &Reported::similarity},
     {{"Shading, mean squared", &MeasuredErrors::shadingSquared}, &Reported::shading},
     {{"Shading, mean absolute", &MeasuredErrors::shading}, nullptr},
     {{"Temporal, image space", &MeasuredErrors::temporalImage}, &Reported::temporal},
     {{"Temporal, object space", &MeasuredErrors::temporalObject}, nullptr}}};

std::string reportedText(const ComparedError& error, const std::string& method) {
    const auto value = reportedError(error, method);
    return value ? fmt::format("{:.5f}", *value) : std::string();
}

}  // namespace

std::span<const ComparedError> comparedErrors() {
    static const auto errors = [] {
        std::array<ComparedError, rows.size()> all{};
        std::ranges::transform(rows, all.begin(), &Row::error);
        return all;
    }();
    return errors;
}

std::optional<double> reportedError(const ComparedError& error, std::string_view method) {
    const auto row =
        std::ranges::find_if(rows, [&](const Row& one) { return one.error.measured == error.measured; });
    const auto column = std::ranges::find(reported, method, &Reported::method);
    if (row == rows.end() || !row->reported || column == reported.end()) return std::nullopt;
    return *column.*row->reported;
}

std::string comparisonMarkdown(const std::vector<MethodMeasure>& table) {
    std::string head = "| error, smaller is better |", rule = "| --- |";
    for (const MethodMeasure& method : table) {
        head += fmt::format(" {} | report |", renderMethod(method.method).label);
        rule += " --- | --- |";
    }
    std::string text = head + "\n" + rule + "\n";
    for (const ComparedError& error : comparedErrors()) {
        text += fmt::format("| {} |", error.name);
        for (const MethodMeasure& method : table) {
            const Estimate& estimate = method.*error.measured;
            text += fmt::format(" {:.5f} ± {:.5f} | {} |", estimate.mean, estimate.standardError,
                                reportedText(error, method.method));
        }
        text += "\n";
    }
    return text;
}

std::string comparisonCsv(const std::vector<MethodMeasure>& table) {
    std::string text = "measure,method,error,standard_error,pixels,report\n";
    for (const ComparedError& error : comparedErrors())
        for (const MethodMeasure& method : table) {
            const Estimate& estimate = method.*error.measured;
            text += fmt::format("\"{}\",{},{:.7f},{:.7f},{},{}\n", error.name, method.method, estimate.mean,
                                estimate.standardError, estimate.count, reportedText(error, method.method));
        }
    return text;
}

std::string framesCsv(const std::vector<MethodMeasure>& table) {
    std::string text = "frame,measure,method,error,standard_error,pixels\n";
    for (const ComparedError& error : comparedErrors())
        for (const MethodMeasure& method : table)
            for (std::size_t frame = 0; frame < method.perFrame.size(); ++frame) {
                const Estimate& estimate = method.perFrame[frame].*error.measured;
                if (estimate.count == 0) continue;
                text += fmt::format("{},\"{}\",{},{:.7f},{:.7f},{}\n", frame + 1, error.name, method.method,
                                    estimate.mean, estimate.standardError, estimate.count);
            }
    return text;
}

}  // namespace chiaro::project
