// Image-based synthesis (§4.1) of a ball: 800 x 200 strip, block 32, k = 4, shading included, as in an
// animation: the sample is prepared once. Errors are mean squared RGB differences over the overlaps, averaged
// over several seeds, since one seed differs from the next by more than the searches do.

#include "core/methods/image_based.h"
#include "core/methods/object_guide.h"
#include "core/scene/guide.h"
#include "core/synthesis/search_kernels.h"
#include "tests/bench/multiply_add_peak.h"
#include "tests/bench/peak_memory.h"
#include "tests/bench/synthesis_reference.h"
#include "tests/bench/thread_counts.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <numeric>

namespace {

using namespace chiaro;

const ColorImage& texture() {
    static const ColorImage made = [] {
        const bench::GeneratedPaint paint = bench::generatePaint(800, 200);
        ColorImage difference = paint.strip;
        for (int y = 0; y < difference.height(); ++y)
            for (int x = 0; x < difference.width(); ++x) difference(x, y) -= paint.gradient[std::size_t(x)];
        return difference;
    }();
    return made;
}

methods::SampleTexture sample() {
    static const synthesis::SearchTexture prepared(texture());
    return {&texture(), &prepared};
}

scene::GBuffer ball(int width, int height) {
    ScalarImage light(width, height, -1.0f);
    const float radius = 0.45f * float(std::min(width, height));
    const glm::vec3 towardsLight = glm::normalize(glm::vec3(-0.5f, 0.7f, 0.6f));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec2 p((float(x) + 0.5f - float(width) / 2) / radius,
                              (float(height) / 2 - float(y) - 0.5f) / radius);
            if (glm::dot(p, p) >= 1) continue;
            const glm::vec3 normal(p, std::sqrt(1 - glm::dot(p, p)));
            light(x, y) = 0.5f + 0.5f * glm::dot(normal, towardsLight);
        }
    return scene::gbufferFromGuide(light);
}

double coveredPixels(const scene::GBuffer& gbuffer) {
    return double(std::ranges::count(gbuffer.objectId.pixels(), std::uint16_t(1)));
}

methods::ImageBasedParams paramsOf(bool draft, std::uint64_t seed = 1) {
    methods::ImageBasedParams params;
    params.draft = draft;
    params.quilt.seed = seed;
    return params;
}

synthesis::QuiltReport render(const scene::GBuffer& gbuffer, const methods::ImageBasedParams& params) {
    const gradient::Gradient gradient{{0.1f, 0.1f, 0.2f}, {1, 0.9f, 0.8f}};
    const methods::ImageBasedTexture made = methods::synthesizeImageBased(gbuffer, {sample()}, params);
    benchmark::DoNotOptimize(methods::shadeImageBased(gbuffer, {&gradient}, made));
    return made.report;
}

// The same with cv::matchTemplate, without shading.
synthesis::QuiltResult renderWithMatchTemplate(const scene::GBuffer& gbuffer, std::uint64_t seed) {
    const methods::ObjectGuide guide = methods::objectGuides(gbuffer, 1).front();
    const methods::ImageBasedParams params = paramsOf(false, seed);
    synthesis::QuiltTask task;
    task.source = &texture();
    task.width = guide.covered.width();
    task.height = guide.covered.height();
    task.valid = &guide.covered;
    task.candidates = [&](const synthesis::BlockSite& site) {
        return methods::windowAround(methods::meanLight(guide, site.position, site.size), params.window,
                                     params.quilt.block, texture());
    };
    return bench::quiltWithMatchTemplate(task, params.quilt);
}

constexpr int seeds = 8;

template <class Error>
double meanError(Error&& error) {
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) sum += error(seed);
    return sum / seeds;
}

double renderError(const scene::GBuffer& gbuffer, bool draft) {
    return meanError([&](std::uint64_t seed) { return render(gbuffer, paramsOf(draft, seed)).overlapError; });
}

struct Seconds {
    double wall = 0;
    double cpu = 0;  ///< of all threads
};

/// The shortest of several runs.
template <class Work>
Seconds timed(int runs, Work&& work) {
    Seconds best{1e9, 1e9};
    for (int run = 0; run < runs; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        const std::clock_t cpu = std::clock();
        work();
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
        best.wall = std::min(best.wall, wall.count());
        best.cpu = std::min(best.cpu, double(std::clock() - cpu) / CLOCKS_PER_SEC);
    }
    return best;
}

// `pixels`: covered pixels a second, which should stay the same whatever the size.
void frame(benchmark::State& state, const char* target, bool draft) {
    synthesis::kernels::onlyUseTarget(target);
    const scene::GBuffer gbuffer = ball(int(state.range(0)), int(state.range(1)));
    for (auto _ : state) render(gbuffer, paramsOf(draft));
    state.counters["covered"] = coveredPixels(gbuffer);
    state.counters["pixels"] =
        benchmark::Counter(coveredPixels(gbuffer) * double(state.iterations()), benchmark::Counter::kIsRate);
    synthesis::kernels::onlyUseTarget(nullptr);
}

// How many times faster than cv::matchTemplate in time and in work of all cores (the reference runs on one),
// and the errors' ratios.
void againstMatchTemplate(benchmark::State& state, const char* target) {
    const scene::GBuffer gbuffer = ball(512, 512);
    static const double referenceError = meanError(
        [&](std::uint64_t seed) { return renderWithMatchTemplate(gbuffer, seed).report().overlapError; });
    synthesis::kernels::onlyUseTarget(target);
    for (auto _ : state) {
        const Seconds exact = timed(10, [&] { render(gbuffer, paramsOf(false)); });
        const Seconds draft = timed(10, [&] { render(gbuffer, paramsOf(true)); });
        const Seconds reference = timed(2, [&] { renderWithMatchTemplate(gbuffer, 1); });
        state.SetIterationTime(exact.wall);
        state.counters["draft_ms"] = 1000 * draft.wall;
        state.counters["reference_ms"] = 1000 * reference.wall;
        state.counters["faster"] = reference.wall / exact.wall;
        state.counters["less_work"] = reference.cpu / exact.cpu;
        state.counters["draft_faster"] = reference.wall / draft.wall;
    }
    const double exactError = renderError(gbuffer, false);
    state.counters["error"] = exactError / referenceError;
    state.counters["draft_error"] = renderError(gbuffer, true) / exactError;
    synthesis::kernels::onlyUseTarget(nullptr);
}

// The exponent with which time grows with the covered pixels: the slope of the logarithms' fitted line.
void growth(benchmark::State& state, const char* target, bool draft) {
    synthesis::kernels::onlyUseTarget(target);
    constexpr std::array sizes{256, 512, 1024, 2048};
    std::vector<scene::GBuffer> gbuffers;
    for (const int size : sizes) gbuffers.push_back(ball(size, size));
    for (auto _ : state) {
        std::array<double, sizes.size()> seconds;
        seconds.fill(1e9);
        for (int run = 0; run < 5; ++run)  // one size after the other, so that a busy moment hits all
            for (std::size_t i = 0; i < sizes.size(); ++i)
                seconds[i] =
                    std::min(seconds[i], timed(1, [&] { render(gbuffers[i], paramsOf(draft)); }).wall);
        glm::dvec2 sum(0), squares(0);
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            const double x = std::log(coveredPixels(gbuffers[i])), y = std::log(seconds[i]);
            sum += glm::dvec2(x, y);
            squares += glm::dvec2(x * x, x * y);
        }
        const auto n = double(sizes.size());
        state.counters["slope"] = (n * squares.y - sum.x * sum.y) / (n * squares.x - sum.x * sum.x);
        state.SetIterationTime(std::accumulate(seconds.begin(), seconds.end(), 0.0));
    }
    synthesis::kernels::onlyUseTarget(nullptr);
}

// Multiply-adds that the exhaustive search of a frame takes, a second; and a second of a core's time (cut,
// copies and all), as a share of what a core can do.
void multiplyAdds(benchmark::State& state, const char* target) {
    synthesis::kernels::onlyUseTarget(target);
    synthesis::QuiltTask task = bench::ballFrame(texture(), 512);
    task.prepared = sample().prepared;
    double wanted = 0;
    for (const synthesis::PlacedBlock& block : synthesis::quilt(task, {}).blocks) {
        const synthesis::CandidateArea area = task.candidates(block.site);
        wanted += 3.0 * double(block.overlapPixels) * area.width * area.height;
    }
    for (auto _ : state) {
        Seconds best{1e9, 1e9};
        double peak = 0;
        for (int run = 0; run < 10; ++run) {
            const Seconds now = timed(2, [&] { benchmark::DoNotOptimize(synthesis::quilt(task, {})); });
            best = {std::min(best.wall, now.wall), std::min(best.cpu, now.cpu)};
            peak = std::max(peak, bench::multiplyAddPeak(target));
        }
        state.SetIterationTime(best.wall);
        state.counters["multiplyAdds"] = wanted / best.wall;
        state.counters["core_peak"] = peak;
        state.counters["share"] = peak > 0 ? wanted / best.cpu / peak : 0;
    }
    synthesis::kernels::onlyUseTarget(nullptr);
}

void memory(benchmark::State& state) {
    const scene::GBuffer gbuffer = ball(4096, 4096);
    bench::takePeakMemory();
    for (auto _ : state) render(gbuffer, paramsOf(false));
    bench::tellPeakMemory(state);
}

// A frame of 512 x 512 by the size of the strip: a block's window stays as wide, and takes all rows.
void stripSize(benchmark::State& state) {
    const bench::GeneratedPaint paint = bench::generatePaint(int(state.range(0)), int(state.range(1)));
    ColorImage difference = paint.strip;
    for (int y = 0; y < difference.height(); ++y)
        for (int x = 0; x < difference.width(); ++x) difference(x, y) -= paint.gradient[std::size_t(x)];
    const synthesis::SearchTexture prepared(difference);
    const scene::GBuffer gbuffer = ball(512, 512);
    for (auto _ : state)
        benchmark::DoNotOptimize(
            methods::synthesizeImageBased(gbuffer, {{&difference, &prepared}}, paramsOf(false)));
}

void threads(benchmark::State& state) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      std::size_t(state.range(0)));
    const scene::GBuffer gbuffer = ball(1024, 1024);
    for (auto _ : state) render(gbuffer, paramsOf(false));
}

// Light or colour moves: the texture that is there is shaded anew. Bytes are those of the view, the texture
// and the picture, each once.
void shade(benchmark::State& state) {
    const scene::GBuffer gbuffer = ball(1920, 1080);
    const gradient::Gradient gradient{{0.1f, 0.1f, 0.2f}, {1, 0.9f, 0.8f}};
    const auto made = methods::synthesizeImageBased(gbuffer, {sample()}, paramsOf(false));
    for (auto _ : state) benchmark::DoNotOptimize(methods::shadeImageBased(gbuffer, {&gradient}, made));
    const std::size_t bytes = gbuffer.light.pixels().size_bytes() + gbuffer.objectId.pixels().size_bytes() +
                              made.objects[0].pixels.pixels().size_bytes() +
                              gbuffer.light.pixels().size() * sizeof(glm::vec3);
    state.SetBytesProcessed(state.iterations() * std::int64_t(bytes));
}

const bool registered = [] {
    const auto add = [](const char* what, const std::string& target, auto... arguments) {
        return benchmark::RegisterBenchmark((std::string(what) + "/" + target).c_str(), arguments...)
            ->Unit(benchmark::kMillisecond);
    };
    for (const char* target : synthesis::kernels::supportedTargets()) {
        if (std::string_view(target) == "SCALAR") continue;  // takes seconds a frame
        for (const bool draft : {false, true}) {
            add(draft ? "draft" : "frame", target, frame, target, draft)
                ->UseRealTime()
                ->MeasureProcessCPUTime()
                ->ArgNames({"width", "height"})
                ->Args({256, 256})
                ->Args({512, 512})
                ->Args({1024, 1024})
                ->Args({2048, 2048})
                ->Args({1920, 1080});
            add(draft ? "draftGrowth" : "growth", target, growth, target, draft)
                ->UseManualTime()
                ->Iterations(1);
        }
        add("againstMatchTemplate", target, againstMatchTemplate, target)->UseManualTime()->Iterations(1);
        add("multiplyAdds", target, multiplyAdds, target)->UseManualTime()->Iterations(1);
    }
    add("memory", "4096", memory)->UseRealTime()->Iterations(1);
    const auto strips = add("stripSize", "best", stripSize)->UseRealTime()->MeasureProcessCPUTime();
    strips->ArgNames({"width", "height"});
    for (const int width : {200, 400, 800, 1600}) strips->Args({width, 200});
    for (const int height : {100, 400}) strips->Args({800, height});
    add("threads", "best", threads)
        ->Apply(bench::threadCounts)
        ->ArgName("threads")
        ->UseRealTime()
        ->MeasureProcessCPUTime();
    add("shade", "best", shade)->UseRealTime()->MeasureProcessCPUTime();
    return true;
}();

}  // namespace
