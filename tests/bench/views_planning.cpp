// Planning the views of the demo head and of half a million faces. "Visibility" is the groups of 12 views of
// the head, to stay below a second on two cores; "Plan" everything from the mesh to the last pass, below ten
// seconds for half a million faces. "memory" is the most that the program had meanwhile, in bytes.

#include "core/scene/mesh_io.h"
#include "core/views/planning.h"
#include "core/views/visibility.h"
#include "tests/bench/peak_memory.h"
#include "tests/bench/thread_counts.h"
#include "tests/core/scene/shapes.h"
#include "tests/support/support.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

namespace chiaro {
namespace {

views::Surface demoHead() {
    const scene::Model model = scene::readModel(test::resource("demo/meshes/skull.glb"));
    return views::Surface(std::make_shared<const scene::Mesh>(scene::merged(model.meshes)));
}

/// Bumpy balls on a grid as one mesh, 22,784 faces each.
scene::Mesh manyFaces(int balls) {
    std::vector<scene::Mesh> meshes;
    for (int i = 0; i < balls; ++i) {
        scene::Mesh mesh = test::ball(128, 90);
        for (glm::vec3& position : mesh.positions)
            position =
                position * (1 + 0.08f * std::sin(9 * position.x) * std::sin(11 * position.y + float(i))) +
                glm::vec3(float(i % 5) * 2, float(i / 5) * 2, 0);
        meshes.push_back(std::move(mesh));
    }
    return scene::merged(meshes);
}

void tell(benchmark::State& state, const views::Surface& surface, const views::ViewPlan& plan) {
    state.counters["faces"] = double(surface.faceCount());
    state.counters["views"] = double(plan.groups.size());
    bench::tellPeakMemory(state);
}

void HeadVisibility(benchmark::State& state) {
    const views::Surface surface = demoHead();
    const views::ViewPlan plan = views::planViews(surface, {});
    const views::FaceMask all(surface.faceCount(), 1);
    for ([[maybe_unused]] auto _ : state) {
        const views::Occluders drawn(surface, all, views::Occluders::Sides::Both, 0);
        for (std::size_t i = 0; i < 12; ++i)
            benchmark::DoNotOptimize(views::visibleFaces(drawn, plan.groups[i].view, {}));
    }
    tell(state, surface, plan);
}
BENCHMARK(HeadVisibility)->Unit(benchmark::kMillisecond)->UseRealTime();

void HeadPlan(benchmark::State& state) {
    const views::Surface surface = demoHead();
    views::ViewPlan plan;
    for ([[maybe_unused]] auto _ : state) plan = views::planViews(surface, {});
    tell(state, surface, plan);
}
BENCHMARK(HeadPlan)->Unit(benchmark::kMillisecond)->UseRealTime();

void plan(benchmark::State& state, int balls) {
    const auto mesh = std::make_shared<const scene::Mesh>(manyFaces(balls));
    bench::takePeakMemory();
    for ([[maybe_unused]] auto _ : state) {
        const views::Surface surface(mesh);
        const views::ViewPlan plan = views::planViews(surface, {});
        tell(state, surface, plan);
    }
}

void ManyFacesPlan(benchmark::State& state) {
    plan(state, int(state.range(0)));
}
BENCHMARK(ManyFacesPlan)
    ->ArgName("balls")
    ->Arg(1)
    ->Arg(5)
    ->Arg(11)
    ->Arg(22)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

void PlanThreads(benchmark::State& state) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      std::size_t(state.range(0)));
    plan(state, 5);
}
BENCHMARK(PlanThreads)
    ->Apply(bench::threadCounts)
    ->ArgName("threads")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace chiaro
