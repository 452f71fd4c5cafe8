#include "core/metrics/study.h"

#include "core/base/error.h"
#include "core/metrics/distortion.h"
#include "core/metrics/similarity.h"

#include <fmt/format.h>

#include <algorithm>

namespace chiaro::metrics {

namespace {

constexpr int builtInSize = 256;
constexpr double smallestScale = 0.5;

ColorImage distorted(const ColorImage& picture, Distortion distortion, double strength, std::uint64_t seed) {
    switch (distortion) {
        case Distortion::Rotation:
            return rotated(picture, strength);
        case Distortion::ScaleX:
            return scaled(picture, strength, 1);
        case Distortion::ScaleY:
            return scaled(picture, 1, strength);
        case Distortion::ScaleBoth:
            return scaled(picture, strength, strength);
        default:
            return torn(picture, int(strength), seed);
    }
}

/// All points of one texture at one block size.
std::vector<StudyPoint> studyTexture(const StudyTexture& texture, int block, const StudyParams& params,
                                     const Task& task) {
    const ColorImage& picture = texture.picture;
    const NeighbourIndex index(picture, block, task.part(0, 0.2));
    const double radius = std::min(picture.width(), picture.height()) / 2.0 * smallestScale - 2;
    const IdImage disc = centralDisc(picture.width(), picture.height(), radius);
    std::vector<StudyPoint> points;
    for (const Distortion distortion : allDistortions)
        for (const double strength : strengthsOf(distortion))
            points.push_back({texture.name, distortion, block, strength, {}});
    for (std::size_t i = 0; i < points.size(); ++i) {
        task.checkpoint();
        StudyPoint& point = points[i];
        const ColorImage changed = distorted(picture, point.distortion, point.strength, params.seed);
        MeasuredFrame frame;
        frame.picture = &changed;
        frame.objects = &disc;
        point.error = measureFrame(index, frame, {block, 1, params.pixels, params.seed}).similarity;
        task.report(0.2 + 0.8 * double(i + 1) / double(points.size()));
    }
    return points;
}

}  // namespace

const char* nameOf(Distortion distortion) {
    constexpr std::array names{"rotation", "scale-x", "scale-y", "scale-both", "discontinuity"};
    return names[std::size_t(distortion)];
}

std::vector<double> strengthsOf(Distortion distortion) {
    std::vector<double> strengths;
    switch (distortion) {
        case Distortion::Rotation:
            for (int degrees = 0; degrees <= 180; degrees += 15) strengths.push_back(degrees);
            break;
        case Distortion::Discontinuity:
            for (int block = 4; block <= 32; block += 4) strengths.push_back(block);
            break;
        default:
            for (int quarter = -4; quarter <= 4; ++quarter) strengths.push_back(std::exp2(quarter / 4.0));
    }
    return strengths;
}

std::vector<StudyTexture> builtInTextures() {
    return {{"random", randomTexture(builtInSize, 1)},
            {"diagonal", diagonalTexture(builtInSize, 1)},
            {"symmetric", symmetricTexture(builtInSize, 1)}};
}

std::vector<StudyPoint> runStudy(const std::vector<StudyTexture>& textures, const StudyParams& params,
                                 const Task& task) {
    std::vector<StudyPoint> points;
    const double runs = double(textures.size() * params.blocks.size());
    double done = 0;
    for (const StudyTexture& texture : textures)
        for (const int block : params.blocks) {
            try {
                std::ranges::move(
                    studyTexture(texture, block, params, task.part(done / runs, (done + 1) / runs)),
                    std::back_inserter(points));
            } catch (const Error& error) {
                throw Error(texture.name, error);
            }
            ++done;
        }
    return points;
}

std::string studyCsv(const std::vector<StudyPoint>& points) {
    std::string text = "texture,distortion,block,value,error,standard_error,pixels\n";
    for (const StudyPoint& point : points)
        text += fmt::format("{},{},{},{:.6g},{:.7f},{:.7f},{}\n", point.texture, nameOf(point.distortion),
                            point.block, point.strength, point.error.mean, point.error.standardError,
                            point.error.count);
    return text;
}

namespace {

/// Values of a member in order of their first appearance.
template <class Member>
auto distinct(const std::vector<StudyPoint>& points, Member StudyPoint::*member) {
    std::vector<Member> values;
    for (const StudyPoint& point : points)
        if (std::ranges::find(values, point.*member) == values.end()) values.push_back(point.*member);
    return values;
}

Series seriesOf(const std::vector<StudyPoint>& points, const std::string& name, const std::string& texture,
                Distortion distortion, int block) {
    Series series{name, {}};
    for (const StudyPoint& point : points)
        if (point.texture == texture && point.distortion == distortion && point.block == block)
            series.points.push_back({point.strength, point.error.mean, point.error.standardError});
    return series;
}

/// A chart for each block size, a curve for each texture.
StudyFigure byBlock(const std::vector<StudyPoint>& points, Distortion distortion, const Axis& axis,
                    const std::string& title) {
    StudyFigure figure{nameOf(distortion), {}, 0};
    for (const int block : distinct(points, &StudyPoint::block)) {
        LineChart chart{fmt::format("{}, s = {}", title, block), axis, {"similarity error", 0, {}}, {}};
        for (const std::string& texture : distinct(points, &StudyPoint::texture))
            chart.series.push_back(seriesOf(points, texture, texture, distortion, block));
        figure.charts.push_back(std::move(chart));
    }
    figure.columns = int(figure.charts.size());
    return figure;
}

/// A row for each texture, a chart for each block size, a curve for each axis.
StudyFigure scaleFigure(const std::vector<StudyPoint>& points, const Axis& axis) {
    const std::vector<int> blocks = distinct(points, &StudyPoint::block);
    StudyFigure figure{"scale", {}, int(blocks.size())};
    for (const std::string& texture : distinct(points, &StudyPoint::texture))
        for (const int block : blocks) {
            LineChart chart{
                fmt::format("Scale, {}, s = {}", texture, block), axis, {"similarity error", 0, {}}, {}};
            chart.series.push_back(seriesOf(points, "x", texture, Distortion::ScaleX, block));
            chart.series.push_back(seriesOf(points, "y", texture, Distortion::ScaleY, block));
            chart.series.push_back(seriesOf(points, "x and y", texture, Distortion::ScaleBoth, block));
            figure.charts.push_back(std::move(chart));
        }
    return figure;
}

}  // namespace

std::vector<StudyFigure> studyFigures(const std::vector<StudyPoint>& points) {
    return {byBlock(points, Distortion::Rotation, {"rotation (degrees)", std::nullopt, {0, 45, 90, 135, 180}},
                    "Rotation"),
            scaleFigure(points, {"scale factor", std::nullopt, {0.5, 0.75, 1, 1.5, 2}, true}),
            byBlock(points, Distortion::Discontinuity,
                    {"block size n (px)", std::nullopt, {4, 8, 12, 16, 20, 24, 28, 32}}, "Discontinuity")};
}

}  // namespace chiaro::metrics
