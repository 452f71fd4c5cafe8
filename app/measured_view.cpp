#include "app/measured_view.h"

#include "core/base/error.h"

#include <algorithm>

namespace chiaro::app {

namespace {

/// The objects that wear one of the strips; nothing is known of the others.
IdImage wornObjects(const MeasuredView& view, std::span<const MeasuredStrip> strips) {
    IdImage objects = view.objects;
    for (std::uint16_t& id : objects.pixels())
        if (std::ranges::none_of(strips, [id](const MeasuredStrip& strip) { return strip.wears[id]; }))
            id = 0;
    return objects;
}

int blockOf(std::span<const MeasuredStrip> strips) {
    if (strips.empty())
        throw Error("view", "shows no object that wears a sample", "open a mesh and a strip of paint");
    return strips.front().index->block();
}

metrics::MeasuredFrame frameOf(const MeasuredView& view, const IdImage& objects) {
    metrics::MeasuredFrame frame;
    frame.picture = &view.picture;
    frame.objects = &objects;
    frame.light = &view.light;
    return frame;
}

/// Each pixel is compared with the strip that its object wears.
std::vector<metrics::PixelMatch> matched(const MeasuredView& view, std::span<const MeasuredStrip> strips,
                                         const std::vector<glm::ivec2>& pixels, int neighbours,
                                         const Task& task) {
    std::vector<metrics::PixelMatch> matches(pixels.size());
    double done = 0;
    for (const MeasuredStrip& strip : strips) {
        std::vector<std::size_t> places;
        std::vector<glm::ivec2> own;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (!strip.wears[view.objects(pixels[i].x, pixels[i].y)]) continue;
            places.push_back(i);
            own.push_back(pixels[i]);
        }
        const double share = double(own.size()) / double(pixels.size());
        const auto found =
            metrics::matchPixels(*strip.index, view.picture, own, neighbours, task.part(done, done + share));
        for (std::size_t i = 0; i < places.size(); ++i) matches[places[i]] = found[i];
        done += share;
    }
    return matches;
}

ViewMatches matchesAt(const MeasuredView& view, std::span<const MeasuredStrip> strips, const IdImage& objects,
                      std::vector<glm::ivec2> pixels, int neighbours, const Task& task) {
    ViewMatches result;
    result.matches = matched(view, strips, pixels, neighbours, task);
    result.measure = metrics::summary(frameOf(view, objects), pixels, result.matches);
    result.pixels = std::move(pixels);
    return result;
}

}  // namespace

ViewMatches measureView(const MeasuredView& view, std::span<const MeasuredStrip> strips,
                        const metrics::MeasureParams& params, const Task& task) {
    metrics::MeasureParams::table().check(params);
    const int block = blockOf(strips);
    const IdImage objects = wornObjects(view, strips);
    auto pixels = metrics::drawPixels(metrics::measurable(frameOf(view, objects), block), params.pixels,
                                      params.seed, "view");
    return matchesAt(view, strips, objects, std::move(pixels), params.neighbours, task);
}

ViewMaps mapView(const MeasuredView& view, std::span<const MeasuredStrip> strips, int step, int neighbours,
                 const Task& task) {
    const int block = blockOf(strips);
    const IdImage objects = wornObjects(view, strips);
    const Image<std::uint8_t> measurable = metrics::measurable(frameOf(view, objects), block);
    Image<std::uint8_t> compared = measurable;
    for (int y = 0; y < compared.height(); ++y)
        for (int x = 0; x < compared.width(); ++x)
            if (x % step != step / 2 || y % step != step / 2) compared(x, y) = 0;
    const ViewMatches found =
        matchesAt(view, strips, objects, metrics::drawPixels(compared, 0, 0, "view"), neighbours, task);
    const int width = measurable.width(), height = measurable.height();
    ViewMaps maps{.similarity = ScalarImage(width, height, -1),
                  .shadingError = ScalarImage(width, height, -1),
                  .best = Image<glm::i16vec2>(width, height, glm::i16vec2(-1)),
                  .measure = found.measure};
    for (std::size_t i = 0; i < found.pixels.size(); ++i) {
        const metrics::PixelMatch& match = found.matches[i];
        const glm::ivec2 corner = found.pixels[i] - step / 2;
        for (int y = corner.y; y < std::min(corner.y + step, height); ++y)
            for (int x = corner.x; x < std::min(corner.x + step, width); ++x) {
                if (!measurable(x, y)) continue;
                maps.similarity(x, y) = match.distance;
                maps.best(x, y) = match.best;
                if (view.light(x, y) >= 0) maps.shadingError(x, y) = std::abs(match.shade - view.light(x, y));
            }
    }
    return maps;
}

}  // namespace chiaro::app
