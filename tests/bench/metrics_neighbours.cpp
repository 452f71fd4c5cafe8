// Exact nearest neighbours under d (§5) in a source of 800 x 200. "Nearest" against "PlainLoop", which scans
// all descriptors as a compiler at -O3 makes of it: both for the same 100 pixels, one thread. "Index" is
// built once a sample. "EveryPixel" matches the pixels of a picture of 512 x 512 on all threads.

#include "core/base/image_io.h"
#include "core/metrics/neighbours.h"
#include "core/metrics/similarity.h"
#include "core/sample/strip.h"
#include "core/synthesis/quilting.h"
#include "tests/support/support.h"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace chiaro {
namespace {

const ColorImage& source() {
    static const ColorImage strip = sample::readStrip(test::resource("demo/samples/oil.png"));
    return strip;
}

/// The source's strokes in another order, as a method would paint with them, and a little blurred: nothing in
/// it is a copy.
ColorImage painted(int width, int height) {
    synthesis::QuiltTask task;
    task.source = &source();
    task.width = width;
    task.height = height;
    const ColorImage quilt = synthesis::quilt(task, {}).texture;
    ColorImage picture = quilt;
    for (int y = 1; y < height; ++y)
        for (int x = 1; x < width; ++x)
            picture(x, y) = 0.6f * quilt(x, y) + 0.2f * (quilt(x - 1, y) + quilt(x, y - 1));
    return picture;
}

std::vector<metrics::Descriptor> queries(const metrics::Bins& bins, int block) {
    const metrics::BinImage image = metrics::binned(painted(512, 512), bins);
    std::vector<metrics::Descriptor> descriptors;
    for (int i = 0; i < 100; ++i)
        descriptors.push_back(metrics::describe(image, {{20 + i * 37 % 470, 20 + i * 101 % 470}, block}));
    return descriptors;
}

/// The plain scan, over descriptors as far apart as their counts.
__attribute__((optimize("O3"))) double plainNearest(const std::vector<metrics::Descriptor>& all,
                                                    const metrics::Descriptor& query) {
    float nearest = std::numeric_limits<float>::infinity();
    for (const metrics::Descriptor& one : all) {
        float sum = 0;
        for (int channel = 0; channel < metrics::channelCount; ++channel) {
            int squares = 0;
            for (int bin = 0; bin < metrics::binCount; ++bin) {
                const auto i = std::size_t(channel * metrics::binCount + bin);
                const int difference = int(one[i]) - int(query[i]);
                squares += difference * difference;
            }
            sum += std::sqrt(float(squares));
        }
        nearest = std::min(nearest, sum);
    }
    return nearest;
}

void Index(benchmark::State& state) {
    std::size_t bytes = 0;
    for ([[maybe_unused]] auto _ : state)
        bytes = metrics::NeighbourIndex(source(), int(state.range(0))).bytes();
    state.counters["MB"] = double(bytes) / 1e6;
}
BENCHMARK(Index)->Arg(4)->Arg(8)->Arg(12)->Arg(16)->Unit(benchmark::kMillisecond)->UseRealTime();

void Nearest(benchmark::State& state) {
    const metrics::NeighbourIndex index(source(), int(state.range(0)));
    const auto wanted = queries(index.bins(), index.block());
    metrics::NeighbourIndex::Memory memory;
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(index.nearest(wanted, 3, memory));
}
BENCHMARK(Nearest)->Arg(4)->Arg(8)->Arg(12)->Arg(16)->Unit(benchmark::kMillisecond);

void PlainLoop(benchmark::State& state) {
    const metrics::Bins bins = metrics::binsOf(source());
    const int block = int(state.range(0));
    const metrics::BinImage image = metrics::binned(source(), bins);
    std::vector<metrics::Descriptor> all;
    for (int y = 0; y + block <= image.height(); ++y)
        for (int x = 0; x + block <= image.width(); ++x)
            all.push_back(metrics::describe(image, {glm::ivec2(x, y) + block / 2, block}));
    const auto wanted = queries(bins, block);
    for ([[maybe_unused]] auto _ : state)
        for (const metrics::Descriptor& one : wanted) benchmark::DoNotOptimize(plainNearest(all, one));
}
BENCHMARK(PlainLoop)->Arg(8)->Iterations(1)->Unit(benchmark::kMillisecond);

void EveryPixel(benchmark::State& state) {
    const metrics::NeighbourIndex index(source(), 8);
    const ColorImage picture = painted(512, 512);
    const metrics::MeasuredFrame frame{.picture = &picture};
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(metrics::mapFrame(index, frame, 3));
}
BENCHMARK(EveryPixel)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace
}  // namespace chiaro
