// The demo skull, view-dependent in the demo oil, to a GLB with an atlas of 2048 texels, its textures made
// before; and a ball of half a million faces all told. `memory` is the most that the process had meanwhile.

#include "core/base/resources.h"
#include "core/project/mesh_export.h"
#include "core/scene/mesh_io.h"
#include "tests/bench/peak_memory.h"
#include "tests/core/scene/shapes.h"
#include "tests/support/support.h"

#include <benchmark/benchmark.h>

namespace {

using namespace chiaro;

struct Stage {
    project::Project project;
    scene::Scene scene;
    std::vector<project::Paint> paints;

    explicit Stage(std::vector<scene::Mesh> meshes) {
        project.method = "view-dependent";
        project.samples.resize(1);
        project.samples[0].scan = resourceFolder() / "demo/samples/oil.png";
        std::vector<std::shared_ptr<const scene::Mesh>> shared;
        for (scene::Mesh& mesh : meshes)
            shared.push_back(std::make_shared<const scene::Mesh>(std::move(mesh)));
        project.meshes = {{"in memory"}};
        scene = project::makeScene(project, {shared});
        paints.push_back(project::preparePaint(project, 0));
    }

    project::WornPaints worn() const { return project::wornPaints(project, scene, paints); }
};

void writeMesh(const Stage& stage, const project::WornPaints& worn) {
    const test::TemporaryFolder folder;
    const project::ExportedMesh mesh =
        project::paintMesh(stage.project, stage.scene, worn, exporting::MeshFormat::Glb, {});
    exporting::writeTexturedScene(folder / "mesh.glb", mesh.scene);
}

void skullAfterSynthesis(benchmark::State& state) {
    static const Stage stage(scene::readModel(resourceFolder() / "demo/meshes/skull.glb").meshes);
    static const project::WornPaints worn = stage.worn();
    bench::takePeakMemory();
    for (auto _ : state) writeMesh(stage, worn);
    bench::tellPeakMemory(state);
}

void halfAMillionFaces(benchmark::State& state) {
    static const Stage stage({test::ball(708, 355)});
    bench::takePeakMemory();
    for (auto _ : state) writeMesh(stage, stage.worn());
    state.counters["faces"] = double(stage.scene.objects[0].mesh->triangles.size());
    bench::tellPeakMemory(state);
}

BENCHMARK(skullAfterSynthesis)->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(halfAMillionFaces)->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime()->Iterations(1);

}  // namespace
