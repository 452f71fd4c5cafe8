// Image-based synthesis (§4.1) of a ball: 800 x 200 strip, block 32, k = 4. `pixels` is the covered pixels a
// second, which should stay the same whatever the size: cost grows with covered pixels alone.

#include "core/methods/image_based.h"
#include "core/scene/guide.h"
#include "core/synthesis/search_kernels.h"
#include "tests/bench/synthesis_reference.h"

#include <benchmark/benchmark.h>

#include <algorithm>

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

void imageBased(benchmark::State& state, const char* target) {
    synthesis::kernels::onlyUseTarget(target);
    const scene::GBuffer gbuffer = ball(int(state.range(0)), int(state.range(1)));
    const auto covered = std::ranges::count(gbuffer.objectId.pixels(), std::uint16_t(1));
    const gradient::Gradient gradient{{0.1f, 0.1f, 0.2f}, {1, 0.9f, 0.8f}};
    synthesis::QuiltReport report;
    for (auto _ : state) {
        const methods::ImageBasedTexture made = methods::synthesizeImageBased(gbuffer, {&texture()}, {});
        report = made.report;
        benchmark::DoNotOptimize(methods::shadeImageBased(gbuffer, {&gradient}, made));
    }
    state.counters["error"] = report.overlapError;
    state.counters["pixels"] =
        benchmark::Counter(double(covered) * double(state.iterations()), benchmark::Counter::kIsRate);
    synthesis::kernels::onlyUseTarget(nullptr);
}

const bool registered = [] {
    for (const char* target : synthesis::kernels::supportedTargets())
        benchmark::RegisterBenchmark((std::string("imageBased/") + target).c_str(), imageBased, target)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MeasureProcessCPUTime()
            ->ArgNames({"width", "height"})
            ->Args({256, 256})
            ->Args({512, 512})
            ->Args({1024, 1024})
            ->Args({2048, 2048})
            ->Args({1920, 1080});
    return true;
}();

}  // namespace
