#include "widgets/metric_axes.h"

#include "widgets/core_text.h"
#include "widgets/round_step.h"

#include <QtCharts>

#include <algorithm>
#include <cmath>
#include <set>

namespace chiaro::widgets {

namespace {

constexpr double room = 0.03;  ///< of the range, for the dots at both ends

struct Range {
    double least = 0, most = 1;
};

Range rangeX(const metrics::LineChart& chart) {
    std::set<double> values(chart.x.ticks.begin(), chart.x.ticks.end());
    for (const metrics::Series& series : chart.series)
        for (const metrics::ChartPoint& point : series.points) values.insert(point.x);
    if (chart.x.least) values.insert(*chart.x.least);
    if (values.empty()) return {};
    return {*values.begin(), *values.rbegin() > *values.begin() ? *values.rbegin() : *values.begin() + 1};
}

}  // namespace

double mostOf(const metrics::LineChart& chart) {
    double most = 0;
    for (const metrics::Series& series : chart.series)
        for (const metrics::ChartPoint& point : series.points) most = std::max(most, point.y + point.error);
    return most;
}

QAbstractAxis* horizontalAxis(const metrics::LineChart& chart) {
    const auto [least, most] = rangeX(chart);
    QAbstractAxis* axis = nullptr;
    if (chart.x.logarithmic) {
        auto* log = new QLogValueAxis;
        log->setBase(2);
        log->setLabelFormat("%g");
        axis = log;
    } else {
        auto* value = new QValueAxis;
        const std::vector<double>& ticks = chart.x.ticks;
        value->setTickType(QValueAxis::TicksDynamic);
        value->setTickAnchor(ticks.empty() ? 0 : ticks.front());
        value->setTickInterval(ticks.size() > 1 ? ticks[1] - ticks[0] : roundStep(most - least, 6));
        value->setLabelFormat("%g");
        axis = value;
    }
    if (chart.x.logarithmic) {
        const double factor = std::pow(most / least, room);
        axis->setRange(least / factor, most * factor);
    } else {
        axis->setRange(least - (most - least) * room, most + (most - least) * room);
    }
    axis->setTitleText(coreText(chart.x.label));
    return axis;
}

QAbstractAxis* verticalAxis(const metrics::LineChart& chart, double atLeast) {
    const double least = chart.y.least.value_or(0);
    double most = std::max(atLeast, mostOf(chart));
    if (!(most > least)) most = least + 1;
    const double step = roundStep(most - least, 4);
    auto* axis = new QValueAxis;
    axis->setTickType(QValueAxis::TicksDynamic);
    axis->setTickAnchor(least);
    axis->setTickInterval(step);
    axis->setRange(least, std::ceil((most - least) / step - 1e-9) * step + least);
    axis->setLabelFormat("%g");
    axis->setTitleText(coreText(chart.y.label));
    return axis;
}

}  // namespace chiaro::widgets
