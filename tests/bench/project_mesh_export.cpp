// The demo skull, view-dependent in the demo oil, to a GLB with an atlas of 2048 texels, its textures made
// before; and a ball of half a million faces all told. `MB` is the most memory that the process had so far.

#include "core/base/resources.h"
#include "core/project/mesh_export.h"
#include "core/scene/mesh_io.h"
#include "tests/core/scene/shapes.h"
#include "tests/support/support.h"

#include <benchmark/benchmark.h>
#include <sys/resource.h>

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
        scene = project::makeScene(project, {shared});
        paints.push_back(project::preparePaint(project, 0));
    }

    project::WornPaints worn() const { return project::wornPaints(project, scene, paints); }
};

void tellMemory(benchmark::State& state) {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["MB"] = double(usage.ru_maxrss) / 1024;
}

void writeMesh(const Stage& stage, const project::WornPaints& worn) {
    const test::TemporaryFolder folder;
    const project::ExportedMesh mesh =
        project::paintMesh(stage.project, stage.scene, worn, exporting::MeshFormat::Glb, {});
    exporting::writeTexturedScene(folder / "mesh.glb", mesh.scene);
}

void skullAfterSynthesis(benchmark::State& state) {
    static const Stage stage(scene::readModel(resourceFolder() / "demo/meshes/skull.glb").meshes);
    static const project::WornPaints worn = stage.worn();
    for (auto _ : state) writeMesh(stage, worn);
    tellMemory(state);
}

void halfAMillionFaces(benchmark::State& state) {
    static const Stage stage({test::ball(708, 355)});
    for (auto _ : state) writeMesh(stage, stage.worn());
    state.counters["faces"] = double(stage.scene.objects[0].mesh->triangles.size());
    tellMemory(state);
}

BENCHMARK(skullAfterSynthesis)->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(halfAMillionFaces)->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime()->Iterations(1);

}  // namespace
