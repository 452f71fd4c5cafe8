#include "core/metrics/line_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace chiaro::metrics {

namespace {

constexpr double chartWidth = 360, chartHeight = 270;
constexpr double left = 58, right = 14, top = 34, bottom = 72;
constexpr double plotWidth = chartWidth - left - right, plotHeight = chartHeight - top - bottom;

// Told apart by the colour-blind too (Okabe and Ito 2008).
constexpr std::array colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
        }
    }
    return result;
}

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
    ChartWriter(std::string& svg, const LineChart& chart, Range rangeX, Range rangeY)
        : m_svg(svg),
          m_chart(chart),
          m_x(chart.x, rangeX.least, rangeX.most, left, left + plotWidth),
          m_y(chart.y, rangeY.least, rangeY.most, top + plotHeight, top) {}

    void write() {
        add(R"(<text x="{:.1f}" y="20" class="title">{}</text>)", left, escaped(m_chart.title));
        writeAxes();
        for (std::size_t i = 0; i < m_chart.series.size(); ++i)
            writeSeries(m_chart.series[i], colors[i % colors.size()]);
        writeLegend();
    }

private:
    template <class... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(m_svg), format, std::forward<Args>(args)...);
        m_svg += '\n';
    }

    void writeAxes() {
        for (const double tick : m_y.ticks()) {
            add(R"(<path d="M{:.1f} {:.1f}h{:.1f}" class="grid"/>)", left, m_y.at(tick), plotWidth);
            add(R"(<text x="{:.1f}" y="{:.1f}" class="right">{:g}</text>)", left - 6, m_y.at(tick) + 4,
                std::abs(tick) < 1e-12 ? 0 : tick);
        }
        for (const double tick : m_x.ticks()) {
            add(R"(<path d="M{:.1f} {:.1f}v4" class="axis"/>)", m_x.at(tick), top + plotHeight);
            add(R"(<text x="{:.1f}" y="{:.1f}" class="middle">{:g}</text>)", m_x.at(tick),
                top + plotHeight + 17, tick);
        }
        add(R"(<path d="M{0:.1f} {1:.1f}v{2:.1f}h{3:.1f}" class="axis"/>)", left, top, plotHeight, plotWidth);
        add(R"(<text x="{:.1f}" y="{:.1f}" class="middle">{}</text>)", left + plotWidth / 2,
            top + plotHeight + 34, escaped(m_chart.x.label));
        add(R"svg(<text transform="translate(14 {:.1f}) rotate(-90)" class="middle">{}</text>)svg",
            top + plotHeight / 2, escaped(m_chart.y.label));
    }

    void writeSeries(const Series& series, const char* color) {
        std::string line, bars;
        for (const ChartPoint& point : series.points) {
            const double x = m_x.at(point.x);
            line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x, m_y.at(point.y));
            if (point.error > 0)
                bars += fmt::format("M{:.1f} {:.1f}V{:.1f}", x, m_y.at(point.y - point.error),
                                    m_y.at(point.y + point.error));
        }
        if (line.empty()) return;
        add(R"(<g stroke="{0}" fill="{0}"><path d="{1}" class="bar"/><path d="{2}" class="curve"/>)", color,
            bars, line);
        for (const ChartPoint& point : series.points)
            add(R"(<circle cx="{:.1f}" cy="{:.1f}" r="2.2"><title>{}: {:.4g}, {:.5f}</title></circle>)",
                m_x.at(point.x), m_y.at(point.y), escaped(series.name), point.x, point.y);
        m_svg += "</g>\n";
    }

    void writeLegend() {
        const double step = plotWidth / double(std::max<std::size_t>(m_chart.series.size(), 1));
        const double y = chartHeight - 12;
        for (std::size_t i = 0; i < m_chart.series.size(); ++i) {
            const double x = left + step * double(i);
            add(R"(<path d="M{:.1f} {:.1f}h14" stroke="{}" class="curve"/>)", x, y - 4,
                colors[i % colors.size()]);
            add(R"(<text x="{:.1f}" y="{:.1f}">{}</text>)", x + 18, y, escaped(m_chart.series[i].name));
        }
    }

    std::string& m_svg;
    const LineChart& m_chart;
    Scale m_x, m_y;
};

}  // namespace

std::string svgOf(const std::vector<LineChart>& charts, int columns) {
    const std::size_t perRow = std::size_t(std::max(columns, 1));
    const std::size_t rows = (charts.size() + perRow - 1) / perRow;
    std::string svg = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}">
<style>text{{font:11px sans-serif;fill:#333}}.title{{font-weight:bold;font-size:13px}}.middle{{text-anchor:middle}}
.right{{text-anchor:end}}.grid{{stroke:#e4e4e4}}.axis{{stroke:#555;fill:none}}.bar{{stroke-width:1;opacity:.5}}
.curve{{stroke-width:1.8;fill:none;stroke-linejoin:round}}</style>
<rect width="100%" height="100%" fill="#fff"/>
)",
        chartWidth * double(std::min(perRow, std::max<std::size_t>(charts.size(), 1))),
        chartHeight * double(rows));
    for (std::size_t row = 0; row < rows; ++row) {
        const std::size_t first = row * perRow, last = std::min(first + perRow, charts.size());
        Range rangeY;
        for (std::size_t i = first; i < last; ++i)
            for (const Series& series : charts[i].series)
                for (const ChartPoint& point : series.points) rangeY.add(point.y + point.error);
        for (std::size_t i = first; i < last; ++i) {
            Range rangeX;
            for (const Series& series : charts[i].series)
                for (const ChartPoint& point : series.points) rangeX.add(point.x);
            svg += fmt::format("<g transform=\"translate({} {})\">\n", chartWidth * double(i - first),
                               chartHeight * double(row));
            ChartWriter(svg, charts[i], rangeX.orUnit(), rangeY.orUnit()).write();
            svg += "</g>\n";
        }
    }
    return svg + "</svg>\n";
}

}  // namespace chiaro::metrics
