#include "app/metric_sheet.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/project/render_method.h"

#include <spdlog/fmt/fmt.h>

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

#include <algorithm>
#include <array>

namespace chiaro::app {

namespace {

using project::MeasuredErrors;

constexpr std::array kinds{
    FrameChart{QT_TRANSLATE_NOOP("Core", "Similarity"),
               QT_TRANSLATE_NOOP("Core", "How little the texture resembles the strip, frame by frame"),
               &MeasuredErrors::similarity},
    FrameChart{QT_TRANSLATE_NOOP("Core", "Shading"),
               QT_TRANSLATE_NOOP("Core", "How far the texture's shade is from the light, frame by frame"),
               &MeasuredErrors::shading},
    FrameChart{QT_TRANSLATE_NOOP("Core", "Image space"),
               QT_TRANSLATE_NOOP("Core", "How much each pixel's texture changes from the frame before"),
               &MeasuredErrors::temporalImage},
    FrameChart{QT_TRANSLATE_NOOP("Core", "Object space"),
               QT_TRANSLATE_NOOP("Core",
                                 "How much the texture of each place of the object changes from the frame "
                                 "before"),
               &MeasuredErrors::temporalObject}};

std::string axisLabel(metrics::Distortion distortion) {
    switch (distortion) {
        case metrics::Distortion::Rotation:
            return QT_TRANSLATE_NOOP("Core", "rotation (degrees)");
        case metrics::Distortion::Discontinuity:
            return QT_TRANSLATE_NOOP("Core", "block size n (px)");
        default:
            return QT_TRANSLATE_NOOP("Core", "scale factor");
    }
}

metrics::Axis axisOf(metrics::Distortion distortion) {
    metrics::Axis axis{axisLabel(distortion), std::nullopt, {}, false};
    if (distortion == metrics::Distortion::Rotation)
        axis.ticks = {0, 45, 90, 135, 180};
    else if (distortion == metrics::Distortion::Discontinuity)
        axis.ticks = {4, 8, 12, 16, 20, 24, 28, 32};
    else
        axis = {axis.label, std::nullopt, {0.5, 0.75, 1, 1.5, 2}, true};
    return axis;
}

/// Whole frames from the first on, at most nine.
std::vector<double> frameTicks(const std::vector<project::MethodMeasure>& table) {
    const std::size_t count = table.empty() ? 0 : table.front().perFrame.size();
    const std::size_t step = count / 9 + 1;
    std::vector<double> ticks;
    for (std::size_t frame = 1; frame <= count; frame += step) ticks.push_back(double(frame));
    return ticks;
}

std::string pngOf(const std::string& svg) {
    constexpr int scale = 2;
    QSvgRenderer renderer(QByteArray::fromStdString(svg));
    QImage image(renderer.defaultSize() * scale, QImage::Format_RGB32);
    image.fill(Qt::white);
    {
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        renderer.render(&painter);
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes.toStdString();
}

}  // namespace

std::span<const FrameChart> frameChartKinds() {
    return kinds;
}

std::vector<metrics::LineChart> frameCharts(const std::vector<project::MethodMeasure>& table) {
    std::vector<metrics::LineChart> charts;
    for (const FrameChart& kind : kinds) {
        metrics::LineChart& chart = charts.emplace_back();
        chart.title = kind.label;
        chart.x.label = QT_TRANSLATE_NOOP("Core", "frame");
        chart.x.ticks = frameTicks(table);
        chart.y.label = QT_TRANSLATE_NOOP("Core", "error");
        chart.y.least = 0;
        for (const project::MethodMeasure& method : table) {
            metrics::Series& series = chart.series.emplace_back();
            series.name = project::renderMethod(method.method).label;
            for (std::size_t frame = 0; frame < method.perFrame.size(); ++frame)
                if (const metrics::Estimate& one = method.perFrame[frame].*kind.error; one.count > 0)
                    series.points.push_back({double(frame + 1), one.mean, one.standardError});
        }
    }
    return charts;
}

std::vector<metrics::LineChart> studyCharts(const std::vector<metrics::StudyPoint>& points,
                                            metrics::Distortion distortion) {
    std::vector<metrics::LineChart> charts;
    std::vector<int> blocks;
    const auto seriesOf = [](metrics::LineChart& chart, const std::string& name) -> metrics::Series& {
        const auto found = std::ranges::find(chart.series, name, &metrics::Series::name);
        return found != chart.series.end() ? *found : chart.series.emplace_back(metrics::Series{name, {}});
    };
    for (const metrics::StudyPoint& point : points) {
        if (point.distortion != distortion) continue;
        auto place = std::ranges::find(blocks, point.block) - blocks.begin();
        if (place == std::ptrdiff_t(blocks.size())) {
            blocks.push_back(point.block);
            charts.push_back({fmt::format("s = {}", point.block),
                              axisOf(distortion),
                              {QT_TRANSLATE_NOOP("Core", "similarity error"), 0, {}},
                              {}});
        }
        seriesOf(charts[std::size_t(place)], point.texture)
            .points.push_back({point.strength, point.error.mean, point.error.standardError});
    }
    return charts;
}

void writeSheet(const std::filesystem::path& path, const MetricSheet& sheet) {
    const std::string extension = path.extension().string();
    std::string bytes;
    if (extension == ".csv") bytes = sheet.csv;
    if (extension == ".md") bytes = sheet.markdown;
    if ((extension == ".svg" || extension == ".png") && !sheet.charts.empty()) {
        bytes = metrics::svgOf(sheet.charts, sheet.columns);
        if (extension == ".png") bytes = pngOf(bytes);
    }
    if (bytes.empty())
        throw Error(path.string(), "is no kind of file that these figures can be written to",
                    sheet.charts.empty() ? "name a .csv or .md" : "name a .csv, .svg or .png");
    writeFileAtomically(path, bytes);
}

}  // namespace chiaro::app
