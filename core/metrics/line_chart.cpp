#include "core/metrics/line_chart.h"

#include "core/metrics/picture_canvas.h"
#include "core/metrics/svg_canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace chiaro::metrics {

namespace {

constexpr double chartWidth = 360, chartHeight = 270;
constexpr double left = 58, right = 14, top = 34, bottom = 72;
constexpr double plotWidth = chartWidth - left - right, plotHeight = chartHeight - top - bottom;

// Told apart by the colour-blind too (Okabe and Ito 2008).
constexpr std::array<unsigned, 7> colors{0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7,
                                         0xe69f00, 0x56b4e9, 0x000000};

/// Round numbers, about five, over a range.
std::vector<double> roundTicks(double least, double most) {
    const double rough = (most - least) / 5;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough) {
            step = factor * power;
            break;
        }
    std::vector<double> ticks;
    for (double i = std::ceil(least / step - 1e-9); i * step <= most + 1e-9 * step; ++i)
        ticks.push_back(i * step);
    return ticks;
}

/// What an axis shows and where on the paper.
class Scale {
public:
    Scale(const Axis& axis, double least, double most, double from, double to)
        : m_logarithmic(axis.logarithmic), m_from(from), m_to(to) {
        if (axis.least) least = *axis.least;
        for (const double tick : axis.ticks) {
            least = std::min(least, tick);
            most = std::max(most, tick);
        }
        if (!(most > least)) most = least + 1;
        if (axis.ticks.empty()) {
            m_ticks = roundTicks(least, most);
            if (m_ticks.size() > 1 && m_ticks.back() < most) {
                m_ticks.push_back(2 * m_ticks.back() - m_ticks[m_ticks.size() - 2]);
                most = m_ticks.back();
            }
        } else {
            m_ticks = axis.ticks;
        }
        m_least = place(least);
        m_most = place(most);
    }

    double at(double value) const {
        return m_from + (place(value) - m_least) / (m_most - m_least) * (m_to - m_from);
    }
    const std::vector<double>& ticks() const { return m_ticks; }

private:
    double place(double value) const { return m_logarithmic ? std::log(std::max(value, 1e-300)) : value; }

    bool m_logarithmic;
    double m_from, m_to;
    double m_least, m_most;
    std::vector<double> m_ticks;
};

struct Range {
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();
    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    Range orUnit() const { return least <= most ? *this : Range{0, 1}; }
};

class ChartWriter {
public:
    ChartWriter(ChartCanvas& canvas, const LineChart& chart, Range rangeX, Range rangeY)
        : m_canvas(canvas),
          m_chart(chart),
          m_x(chart.x, rangeX.least, rangeX.most, left, left + plotWidth),
          m_y(chart.y, rangeY.least, rangeY.most, top + plotHeight, top) {}

    void write() {
        m_canvas.text({left, 20}, m_chart.title, Anchor::Start, Lettering::Title);
        writeAxes();
        for (std::size_t i = 0; i < m_chart.series.size(); ++i)
            writeSeries(m_chart.series[i], colors[i % colors.size()]);
        writeLegend();
    }

private:
    void line(std::initializer_list<glm::dvec2> points, Stroke stroke, unsigned color = 0) {
        m_canvas.line(std::span(points.begin(), points.size()), stroke, color);
    }

    void writeAxes() {
        constexpr double base = top + plotHeight;
        for (const double tick : m_y.ticks()) {
            line({{left, m_y.at(tick)}, {left + plotWidth, m_y.at(tick)}}, Stroke::Grid);
            m_canvas.text({left - 6, m_y.at(tick) + 4},
                          fmt::format("{:g}", std::abs(tick) < 1e-12 ? 0 : tick), Anchor::End);
        }
        for (const double tick : m_x.ticks()) {
            line({{m_x.at(tick), base}, {m_x.at(tick), base + 4}}, Stroke::Axis);
            m_canvas.text({m_x.at(tick), base + 17}, fmt::format("{:g}", tick), Anchor::Middle);
        }
        line({{left, top}, {left, base}, {left + plotWidth, base}}, Stroke::Axis);
        m_canvas.text({left + plotWidth / 2, base + 34}, m_chart.x.label, Anchor::Middle);
        m_canvas.text({14, top + plotHeight / 2}, m_chart.y.label, Anchor::Upward);
    }

    void writeSeries(const Series& series, unsigned color) {
        std::vector<glm::dvec2> curve;
        for (const ChartPoint& point : series.points) {
            const double x = m_x.at(point.x);
            curve.emplace_back(x, m_y.at(point.y));
            if (point.error > 0)
                line({{x, m_y.at(point.y - point.error)}, {x, m_y.at(point.y + point.error)}}, Stroke::Bar,
                     color);
        }
        if (curve.empty()) return;
        m_canvas.line(curve, Stroke::Curve, color);
        for (std::size_t i = 0; i < curve.size(); ++i)
            m_canvas.dot(
                curve[i], color,
                fmt::format("{}: {:.4g}, {:.5f}", series.name, series.points[i].x, series.points[i].y));
    }

    void writeLegend() {
        const double step = plotWidth / double(std::max<std::size_t>(m_chart.series.size(), 1));
        const double y = chartHeight - 12;
        for (std::size_t i = 0; i < m_chart.series.size(); ++i) {
            const double x = left + step * double(i);
            line({{x, y - 4}, {x + 14, y - 4}}, Stroke::Curve, colors[i % colors.size()]);
            m_canvas.text({x + 18, y}, m_chart.series[i].name, Anchor::Start);
        }
    }

    ChartCanvas& m_canvas;
    const LineChart& m_chart;
    Scale m_x, m_y;
};

std::size_t inRow(int columns) {
    return std::size_t(std::max(columns, 1));
}

glm::dvec2 sizeOf(const std::vector<LineChart>& charts, int columns) {
    const std::size_t perRow = inRow(columns), rows = (charts.size() + perRow - 1) / perRow;
    return {chartWidth * double(std::clamp<std::size_t>(charts.size(), 1, perRow)),
            chartHeight * double(std::max<std::size_t>(rows, 1))};
}

void draw(const std::vector<LineChart>& charts, int columns, ChartCanvas& canvas) {
    const std::size_t perRow = inRow(columns);
    for (std::size_t first = 0; first < charts.size(); first += perRow) {
        const auto row = std::span(charts).subspan(first, std::min(perRow, charts.size() - first));
        Range rangeY;
        for (const LineChart& chart : row)
            for (const Series& series : chart.series)
                for (const ChartPoint& point : series.points) rangeY.add(point.y + point.error);
        for (std::size_t i = 0; i < row.size(); ++i) {
            Range rangeX;
            for (const Series& series : row[i].series)
                for (const ChartPoint& point : series.points) rangeX.add(point.x);
            canvas.moveTo({chartWidth * double(i), chartHeight * double(first / perRow)});
            ChartWriter(canvas, row[i], rangeX.orUnit(), rangeY.orUnit()).write();
        }
    }
}

}  // namespace

std::string svgOf(const std::vector<LineChart>& charts, int columns) {
    SvgCanvas canvas(sizeOf(charts, columns));
    draw(charts, columns, canvas);
    return canvas.svg();
}

ColorImage pictureOf(const std::vector<LineChart>& charts, int columns) {
    PictureCanvas canvas(sizeOf(charts, columns));
    draw(charts, columns, canvas);
    return canvas.picture();
}

}  // namespace chiaro::metrics
