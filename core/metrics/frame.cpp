#include "core/metrics/frame.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/metrics/descriptor.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace chiaro::metrics {

const ParameterTable<MeasureParams>& MeasureParams::table() {
    static const auto table =
        ParameterTable<MeasureParams>()
            .add(&MeasureParams::block,
                 ParameterSpec::integer("block", "Block", "px", smallestBlock, largestBlock,
                                        "Side of the blocks whose colours and edges are compared."))
            .add(&MeasureParams::neighbours,
                 ParameterSpec::integer("neighbours", "Neighbours", "", 1, 16,
                                        "How many of the most similar places of the sample say which shade a "
                                        "pixel's texture is meant for."))
            .add(&MeasureParams::seed,
                 ParameterSpec::integer("seed", "Seed", "", 0, 0x1p53, "Seed of the pixels that are drawn."))
            .add(&MeasureParams::pixels,
                 ParameterSpec::integer("pixels", "Pixels", "", 0, 1e9,
                                        "How many pixels are drawn by chance and measured; 0 is every one."));
    return table;
}

Estimate estimate(const std::vector<double>& values) {
    Estimate result{.count = values.size()};
    if (values.empty()) return result;
    const double count = double(values.size());
    result.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    if (values.size() < 2) return result;
    double squares = 0;
    for (const double value : values) squares += (value - result.mean) * (value - result.mean);
    result.standardError = std::sqrt(squares / (count - 1) / count);
    return result;
}

namespace {

template <class Pixel>
void checkSize(const char* subject, const Image<Pixel>* image, const ColorImage& picture) {
    if (!image || (image->width() == picture.width() && image->height() == picture.height())) return;
    throw Error(subject, fmt::format("is {} x {} pixels", image->width(), image->height()),
                fmt::format("the picture is {} x {}, and both must be of one size", picture.width(),
                            picture.height()));
}

}  // namespace

Image<std::uint8_t> measurable(const MeasuredFrame& frame, int block) {
    const ColorImage& picture = *frame.picture;
    checkSize("mask", frame.objects, picture);
    checkSize("light", frame.light, picture);
    if (picture.width() < block || picture.height() < block)
        throw Error("picture",
                    fmt::format("is {} x {} pixels, smaller than a block of {} px", picture.width(),
                                picture.height(), block),
                    "choose a larger picture or a smaller block");
    const auto objectAt = [&](int x, int y) { return frame.objects ? (*frame.objects)(x, y) : 1; };
    Image<std::uint8_t> result(picture.width(), picture.height(), 0);
    // Side of the largest square of one object whose bottom right pixel this is, up to a block.
    Image<std::uint8_t> side(picture.width(), picture.height(), 0);
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const int object = objectAt(x, y);
            if (object == 0 || (frame.object != 0 && object != frame.object)) continue;
            int reach = 0;
            if (x > 0 && y > 0 && objectAt(x - 1, y) == object && objectAt(x, y - 1) == object &&
                objectAt(x - 1, y - 1) == object)
                reach = std::min({side(x - 1, y), side(x, y - 1), side(x - 1, y - 1)});
            side(x, y) = std::uint8_t(std::min(reach + 1, block));
            if (side(x, y) == block) result(x - block + 1 + block / 2, y - block + 1 + block / 2) = 1;
        }
    return result;
}

bool anyPixel(const Image<std::uint8_t>& mask) {
    return std::ranges::any_of(mask.pixels(), [](std::uint8_t value) { return value != 0; });
}

std::vector<glm::ivec2> drawPixels(const Image<std::uint8_t>& from, int count, std::uint64_t seed,
                                   const char* what) {
    std::vector<glm::ivec2> pixels;
    for (int y = 0; y < from.height(); ++y)
        for (int x = 0; x < from.width(); ++x)
            if (from(x, y)) pixels.emplace_back(x, y);
    if (pixels.empty())
        throw Error(
            what, "leaves no pixel to measure",
            "blocks must lie wholly inside the picture and on one object, so choose a smaller block or "
            "a larger picture");
    if (count == 0 || std::size_t(count) >= pixels.size()) return pixels;
    Random random(seed);
    for (std::size_t i = 0; i < std::size_t(count); ++i)
        std::swap(pixels[i], pixels[i + random.below(pixels.size() - i)]);
    pixels.resize(std::size_t(count));
    return pixels;
}

}  // namespace chiaro::metrics
