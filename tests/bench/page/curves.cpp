#include "tests/bench/page/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace chiaro::bench {

namespace {

using metrics::ChartPoint;
using metrics::Series;

/// A number of a run's name, as 512 of "frame/AVX2/width:512/height:512"; 0 without.
double argument(const Run& run, const std::string& name) {
    const auto at = run.name.find("/" + name + ":");
    return at == std::string::npos ? 0 : std::atof(run.name.c_str() + at + name.size() + 2);
}

double figure(const Run& run, const std::string& name) {
    const auto found = run.figures.find(name);
    return found == run.figures.end() ? 0 : found->second;
}

using Measure = std::function<double(const Run&)>;

Series series(const std::string& name, std::vector<Run> runs, const Measure& x, const Measure& y) {
    Series result{name, {}};
    for (const Run& run : runs) result.points.push_back({x(run), y(run)});
    std::ranges::sort(result.points, {}, &ChartPoint::x);
    return result;
}

double milliseconds(const Run& run) {
    return 1e3 * figure(run, "real_time");
}
double seconds(const Run& run) {
    return figure(run, "real_time");
}

/// 1, 2, 5, 10, .. around all values of an axis.
std::vector<double> roundFactors(const std::vector<Series>& all, double ChartPoint::*axis) {
    double least = INFINITY, most = 0;
    for (const Series& one : all)
        for (const ChartPoint& point : one.points) {
            least = std::min(least, point.*axis);
            most = std::max(most, point.*axis);
        }
    std::vector<double> ticks;
    if (!(least > 0) || !(most >= least)) return ticks;
    for (double power = std::pow(10, std::floor(std::log10(least)));; power *= 10)
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (factor * power <= least) ticks.clear();
            ticks.push_back(factor * power);
            if (ticks.back() >= most) return ticks;
        }
}

/// Every decade of ticks where there are too many to letter.
std::vector<double> thinned(std::vector<double> ticks) {
    if (ticks.size() <= 8) return ticks;
    std::vector<double> decades;
    for (const double tick : ticks) {
        const double power = std::log10(tick);
        if (std::abs(power - std::round(power)) < 1e-6 || tick == ticks.front() || tick == ticks.back())
            decades.push_back(tick);
    }
    return decades;
}

/// With what power of x a curve grows: the slope of the logarithms' fitted line.
double growthOf(const Series& one) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const ChartPoint& point : one.points) {
        const double a = std::log(point.x), b = std::log(point.y);
        n += 1, x += a, y += b, xx += a * a, xy += a * b;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

metrics::LineChart logarithmic(std::string title, std::string x, std::string y, std::vector<Series> all) {
    metrics::LineChart chart{std::move(title), {}, {}, std::move(all)};
    chart.x = {std::move(x), {}, thinned(roundFactors(chart.series, &ChartPoint::x)), true};
    chart.y = {std::move(y), {}, thinned(roundFactors(chart.series, &ChartPoint::y)), true};
    return chart;
}

Curves pixels(const Results& results) {
    const Measure covered = [](const Run& run) { return 1e-3 * figure(run, "covered"); };
    const Series fine = series("fine", results.runs("methods", "frame/{simd}"), covered, milliseconds);
    const Series draft = series("draft", results.runs("methods", "draft/{simd}"), covered, milliseconds);
    return {
        "pixels.svg", logarithmic("Covered pixels", "thousand covered pixels", "ms", {fine, draft}),
        fmt::format("An image-based picture by the pixels that the object covers: the time grows with them "
                    "to the power {:.2f}, a draft's to {:.2f}.",
                    growthOf(fine), growthOf(draft))};
}

Curves strip(const Results& results) {
    std::vector<Run> wider, higher;
    for (const Run& run : results.runs("methods", "stripSize/best")) {
        if (argument(run, "height") == 200) wider.push_back(run);
        if (argument(run, "width") == 800) higher.push_back(run);
    }
    const Measure size = [](const Run& run) {
        return 1e-3 * argument(run, "width") * argument(run, "height");
    };
    const Series byWidth = series("wider", wider, size, milliseconds);
    const Series byHeight = series("higher", higher, size, milliseconds);
    return {
        "strip.svg",
        logarithmic("Size of the strip", "thousand pixels of the strip", "ms", {byWidth, byHeight}),
        fmt::format("An image-based picture of 512 x 512 by the size of the strip. Twice as high is twice "
                    "as many places to look at (power {:.2f}); twice as wide is not, since a block looks "
                    "no further than its window (power {:.2f}).",
                    growthOf(byHeight), growthOf(byWidth))};
}

Curves faces(const Results& results) {
    const Series plan = series(
        "views planned", results.runs("views", "ManyFacesPlan"),
        [](const Run& run) { return 1e-3 * figure(run, "faces"); }, seconds);
    return {"faces.svg", logarithmic("Faces", "thousand faces", "s", {plan}),
            fmt::format("Planning the views of a mesh by its faces: power {:.2f}.", growthOf(plan))};
}

Curves views(const Results& results) {
    metrics::LineChart chart{"Views",
                             {"views asked for", 0, {}, false},
                             {"s", 0, {}, false},
                             {series(
                                 "textures", results.runs("project", "textures"),
                                 [](const Run& run) { return argument(run, "views"); }, seconds)}};
    return {"views.svg", chart,
            "The textures of the demo skull by the number of views asked for: another view is only painted "
            "where no view before shows the surface as well, so that the time grows slower than the number."};
}

/// How many times faster than on one thread.
Series speedUp(const std::string& name, const std::vector<Run>& runs) {
    Series result = series(
        name, runs, [](const Run& run) { return argument(run, "threads"); }, seconds);
    if (result.points.empty()) return result;
    const double one = result.points.front().y;
    for (ChartPoint& point : result.points) point.y = one / point.y;
    return result;
}

Curves threads(const Results& results) {
    std::vector<Series> all{speedUp("frame", results.runs("methods", "threads/best")),
                            speedUp("views", results.runs("views", "PlanThreads")),
                            speedUp("triad", results.runs("base", "triad"))};
    std::string words = "How many times faster than on one thread";
    std::vector<double> counts;
    for (const Series& one : all) {
        if (one.points.empty()) continue;
        words += fmt::format("{} {:.2f} ({})", counts.empty() ? ": on all of them" : ",", one.points.back().y,
                             one.name);
        counts.clear();
        for (const ChartPoint& point : one.points) counts.push_back(point.x);
    }
    metrics::LineChart chart{"Threads", {"threads", {}, counts, false}, {"times faster", 0, {}, false}, all};
    return {"threads.svg", chart,
            words +
                ". *frame* is an image-based picture of 1024 x 1024, *views* the planning of a mesh, and "
                "*triad* what the memory itself gains."};
}

bool hasCurve(const Curves& curves) {
    return std::ranges::any_of(curves.chart.series, [](const Series& one) { return one.points.size() > 1; });
}

}  // namespace

std::vector<Curves> scalingCurves(const Results& results) {
    std::vector<Curves> all;
    for (const auto& make : {pixels, strip, faces, views, threads})
        if (Curves curves = make(results); hasCurve(curves)) {
            std::erase_if(curves.chart.series, [](const Series& one) { return one.points.empty(); });
            all.push_back(std::move(curves));
        }
    return all;
}

}  // namespace chiaro::bench
