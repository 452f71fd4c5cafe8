// The textures of the demo skull's views (§4.3.5) in the demo oil, its views planned before: by the number of
// views asked for, and the default ones read from the cache.

#include "core/base/resources.h"
#include "core/project/pipeline.h"
#include "core/scene/mesh_io.h"
#include "tests/bench/peak_memory.h"
#include "tests/support/support.h"

#include <benchmark/benchmark.h>

namespace {

using namespace chiaro;

struct Stage {
    project::Project project;
    scene::Scene scene;
    project::Paint paint;
    std::shared_ptr<const methods::PlannedObject> planned;

    explicit Stage(int views) {
        project.method = "view-dependent";
        project.views.count = views;
        project.samples.resize(1);
        project.samples[0].scan = resourceFolder() / "demo/samples/oil.png";
        project.meshes = {{resourceFolder() / "demo/meshes/skull.glb"}};
        project::MeshList meshes;
        for (scene::Mesh& mesh : scene::readModel(project.meshes[0].path).meshes)
            meshes.push_back(std::make_shared<const scene::Mesh>(std::move(mesh)));
        scene = project::makeScene(project, {meshes});
        paint = project::preparePaint(project, 0);
        planned = project::planObject(project, scene, 0);
    }

    auto make(const project::TextureCache* cache = nullptr) const {
        return project::paintObject(project, planned, paint, {}, cache);
    }
};

void textures(benchmark::State& state) {
    const Stage stage(int(state.range(0)));
    bench::takePeakMemory();
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(stage.make());
    bench::tellPeakMemory(state);
    state.counters["groups"] = double(stage.planned->plan.groups.size());  // views with those for the rest
}
BENCHMARK(textures)
    ->ArgName("views")
    ->Arg(4)
    ->Arg(8)
    ->Arg(12)
    ->Arg(16)
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Iterations(1);

void texturesFromCache(benchmark::State& state) {
    const Stage stage(12);
    const test::TemporaryFolder folder;
    const project::TextureCache cache(folder.path());
    stage.make(&cache);
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(stage.make(&cache));
    const auto file = test::filesIn(folder.path()).front();
    state.SetBytesProcessed(state.iterations() * std::int64_t(std::filesystem::file_size(file)));
}
BENCHMARK(texturesFromCache)->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace
