// The report's table (§5) on the demo's skull in each of the demo's strips, as "chiaro compare" makes it with
// one seed: its counters are the errors of image-based (ib), view-aligned (va) and view-dependent (vd)
// frames, similarity, then coherence in image and in object space.

#include "core/project/comparison.h"
#include "core/scene/mesh_io.h"
#include "tests/support/support.h"

#include <benchmark/benchmark.h>

namespace chiaro {
namespace {

constexpr std::array strips{"oil", "charcoal", "hatching", "impasto", "pastel", "watercolour"};

void Comparison(benchmark::State& state) {
    const std::string strip = strips[std::size_t(state.range(0))];
    project::Project project = project::readProject(test::resource("demo/demo.chiaro"));
    for (project::Sample& sample : project.samples)
        sample.scan = test::resource("demo/samples/" + strip + ".png");
    std::vector<std::shared_ptr<const scene::Mesh>> meshes;
    for (const scene::Mesh& mesh : scene::readModel(project.meshes.at(0).path).meshes)
        meshes.push_back(std::make_shared<const scene::Mesh>(mesh));
    const scene::Scene scene = project::makeScene(project, {meshes});
    project::ComparisonParams params;
    params.seeds = 1;
    params.measure.pixels = 1000;
    std::vector<project::MethodMeasure> table;
    for ([[maybe_unused]] auto _ : state)
        table = project::compareMethods(project::animatedAsReported(project), scene,
                                        scene::Path::approaching(), params);
    constexpr std::array names{"ib", "va", "vd"};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const std::string name = names[i];
        state.counters["1 similarity " + name] = table[i].similarity.mean;
        state.counters["2 image " + name] = table[i].temporalImage.mean;
        state.counters["3 object " + name] = table[i].temporalObject.mean;
    }
    state.SetLabel(strip);
}
BENCHMARK(Comparison)
    ->DenseRange(0, int(strips.size()) - 1)
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();

}  // namespace
}  // namespace chiaro
