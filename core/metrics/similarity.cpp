#include "core/metrics/similarity.h"

#include "core/base/error.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace chiaro::metrics {

namespace {

constexpr std::size_t pixelsAtOnce = 16;  // two batches

PixelMatch matchOf(const std::vector<Neighbour>& nearest, int sourceWidth) {
    double shade = 0;
    for (const Neighbour& neighbour : nearest) shade += double(neighbour.pixel.x) / (sourceWidth - 1);
    return {float(nearest.front().distance), float(shade / double(nearest.size())),
            glm::i16vec2(nearest.front().pixel)};
}

/// True L at a pixel; none where the light picture says that nothing is there.
std::optional<double> lightAt(const MeasuredFrame& frame, glm::ivec2 pixel) {
    if (!frame.light) return std::nullopt;
    const float light = (*frame.light)(pixel.x, pixel.y);
    return light >= 0 ? std::optional<double>(light) : std::nullopt;  // NaN fails the comparison
}

}  // namespace

FrameMeasure summary(const MeasuredFrame& frame, std::span<const glm::ivec2> pixels,
                     std::span<const PixelMatch> matches) {
    std::vector<double> distances, absolute, squared;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        distances.push_back(matches[i].distance);
        if (const auto light = lightAt(frame, pixels[i])) {
            const double error = matches[i].shade - *light;
            absolute.push_back(std::abs(error));
            squared.push_back(error * error);
        }
    }
    FrameMeasure measure{.similarity = estimate(distances), .shadingAbsolute = {}, .shadingSquared = {}};
    if (!absolute.empty()) {
        measure.shadingAbsolute = estimate(absolute);
        measure.shadingSquared = estimate(squared);
    }
    return measure;
}

std::vector<PixelMatch> matchPixels(const NeighbourIndex& source, const ColorImage& picture,
                                    std::span<const glm::ivec2> pixels, int neighbours, const Task& task) {
    const BinImage bins = binned(picture, source.bins());
    std::vector<PixelMatch> matches(pixels.size());
    tbb::enumerable_thread_specific<NeighbourIndex::Memory> memories;
    Task::Steps steps(task, pixels.size() / pixelsAtOnce + 1);
    const tbb::blocked_range<std::size_t> all(0, pixels.size(), pixelsAtOnce);
    tbb::parallel_for(
        all,
        [&](const tbb::blocked_range<std::size_t>& range) {
            task.checkpoint();
            std::vector<Descriptor> wanted;
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                wanted.push_back(describe(bins, {pixels[i], source.block()}));
            const auto found = source.nearest(wanted, neighbours, memories.local());
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                matches[i] = matchOf(found[i - range.begin()], source.width());
            steps.done();
        },
        tbb::simple_partitioner());
    return matches;
}

FrameMeasure measureFrame(const NeighbourIndex& source, const MeasuredFrame& frame,
                          const MeasureParams& params, const Task& task) {
    MeasureParams::table().check(params);
    if (params.block != source.block())
        throw Error("block", fmt::format("is {} px", params.block),
                    fmt::format("the sample was prepared for blocks of {} px", source.block()));
    const std::vector<glm::ivec2> pixels =
        drawPixels(measurable(frame, params.block), params.pixels, params.seed, "mask");
    return summary(frame, pixels, matchPixels(source, *frame.picture, pixels, params.neighbours, task));
}

FrameMaps mapFrame(const NeighbourIndex& source, const MeasuredFrame& frame, int neighbours,
                   const Task& task) {
    const int width = frame.picture->width(), height = frame.picture->height();
    const std::vector<glm::ivec2> pixels = drawPixels(measurable(frame, source.block()), 0, 0, "mask");
    const std::vector<PixelMatch> matches = matchPixels(source, *frame.picture, pixels, neighbours, task);
    FrameMaps maps{.similarity = ScalarImage(width, height, -1),
                   .shadingError = ScalarImage(width, height, -1),
                   .best = Image<glm::i16vec2>(width, height, glm::i16vec2(-1)),
                   .measure = summary(frame, pixels, matches)};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::ivec2 pixel = pixels[i];
        maps.similarity(pixel.x, pixel.y) = matches[i].distance;
        maps.best(pixel.x, pixel.y) = matches[i].best;
        if (const auto light = lightAt(frame, pixel))
            maps.shadingError(pixel.x, pixel.y) = std::abs(matches[i].shade - float(*light));
    }
    return maps;
}

}  // namespace chiaro::metrics
