// The quilting engine against the same quilting with cv::matchTemplate(TM_SQDIFF), in one run. Compare times
// as ratios; `error` is the mean squared RGB difference over the overlaps, `multiplyAdds` what an exhaustive
// search computes for its cross terms.

#include "tests/bench/synthesis_reference.h"

#include <benchmark/benchmark.h>

namespace {

using namespace chiaro;
using namespace chiaro::synthesis;

const bench::GeneratedPaint& paint() {
    static const bench::GeneratedPaint made = bench::generatePaint(800, 200);
    return made;
}

const ColorImage& texture() {
    static const ColorImage made = [] {
        ColorImage difference = paint().strip;
        for (int y = 0; y < difference.height(); ++y)
            for (int x = 0; x < difference.width(); ++x) difference(x, y) -= paint().gradient[std::size_t(x)];
        return difference;
    }();
    return made;
}

void levels(benchmark::State& state, const char* target) {
    kernels::onlyUseTarget(target);
    QuiltReport report;
    for (auto _ : state) report = makeLevels(paint().strip, paint().gradient, {}).report;
    state.counters["error"] = report.overlapError;
    kernels::onlyUseTarget(nullptr);
}

void levelsMatchTemplate(benchmark::State& state) {
    QuiltReport report;
    for (auto _ : state) report = bench::levelsWithMatchTemplate(paint(), {});
    state.counters["error"] = report.overlapError;
}

QuiltParams frameParams(const benchmark::State& state) {
    QuiltParams params;
    params.overlap = int(state.range(0));
    return params;
}

void frame(benchmark::State& state, const char* target) {
    kernels::onlyUseTarget(target);
    const QuiltTask task = bench::ballFrame(texture(), 512);
    double multiplyAdds = 0;
    QuiltReport report;
    for (auto _ : state) {
        const QuiltResult result = quilt(task, frameParams(state));
        report = result.report();
        for (const PlacedBlock& block : result.blocks) {
            const CandidateArea area = task.candidates(block.site);
            multiplyAdds += 3.0 * double(block.overlapPixels) * area.width * area.height;
        }
    }
    state.counters["error"] = report.overlapError;
    state.counters["multiplyAdds"] = benchmark::Counter(multiplyAdds, benchmark::Counter::kIsRate);
    kernels::onlyUseTarget(nullptr);
}

void frameMatchTemplate(benchmark::State& state) {
    const QuiltTask task = bench::ballFrame(texture(), 512);
    QuiltReport report;
    for (auto _ : state) report = bench::quiltWithMatchTemplate(task, frameParams(state)).report();
    state.counters["error"] = report.overlapError;
}

// Names of the instruction sets must live as long as the benchmarks do.
const bool registered = [] {
    const auto settled = [](benchmark::internal::Benchmark* b) {
        return b->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
    };
    for (const char* target : kernels::supportedTargets()) {
        settled(benchmark::RegisterBenchmark((std::string("levels/") + target).c_str(), levels, target));
        settled(benchmark::RegisterBenchmark((std::string("frame/") + target).c_str(), frame, target))
            ->ArgName("overlap")
            ->Arg(5)
            ->Arg(8);
    }
    settled(benchmark::RegisterBenchmark("levels/matchTemplate", levelsMatchTemplate))->Iterations(1);
    settled(benchmark::RegisterBenchmark("frame/matchTemplate", frameMatchTemplate))
        ->ArgName("overlap")
        ->Arg(5)
        ->Arg(8)
        ->Iterations(1);
    return true;
}();

}  // namespace
