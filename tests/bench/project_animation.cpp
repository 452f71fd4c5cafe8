// A 48-frame turntable of the demo skull in the demo oil, 512 x 512, image-based: the frames' pictures in
// memory, G-buffers and shading included, files not. `frames` is frames a second.

#include "core/base/resources.h"
#include "core/project/animation.h"
#include "core/scene/mesh_io.h"

#include <benchmark/benchmark.h>

namespace {

using namespace chiaro;
using methods::Coherence;

constexpr int frames = 48;

struct Stage {
    project::Project project;
    scene::Scene scene;
    std::vector<project::Paint> paints;
    project::WornPaints worn;

    Stage() {
        const auto demo = resourceFolder() / "demo";
        project.method = "image-based";
        project.samples.push_back(
            {.name = "oil", .scan = demo / "samples/oil.png", .strip = {}, .gradient = {}, .recoloring = {}});
        project.meshes = {{demo / "meshes/skull.glb"}};
        project::MeshList meshes;
        for (const scene::Mesh& mesh : scene::readModel(project.meshes[0].path).meshes)
            meshes.push_back(std::make_shared<const scene::Mesh>(mesh));
        scene = project::makeScene(project, {meshes});
        paints.push_back(project::preparePaint(project, 0));
        worn = project::wornPaints(project, scene, paints);
    }
};

void turntable(benchmark::State& state, Coherence coherence) {
    static Stage stage;
    stage.project.coherence.mode = coherence;
    const project::Shot shot{stage.project, stage.scene, stage.worn, scene::Path::turntable(frames),
                             512,           512};
    for (auto _ : state) {
        project::ShotViews views(shot);
        const auto painter = project::framePainter(shot, views);
        for (int frame = 1; frame <= frames; ++frame) benchmark::DoNotOptimize(painter->paint(frame, {}));
    }
    state.counters["frames"] =
        benchmark::Counter(double(frames) * double(state.iterations()), benchmark::Counter::kIsRate);
}

const bool registered = [] {
    for (const auto& [name, coherence] :
         {std::pair("independent", Coherence::Independent), std::pair("previous", Coherence::Previous),
          std::pair("keyframes", Coherence::Keyframes), std::pair("reprojected", Coherence::Reprojected)})
        benchmark::RegisterBenchmark((std::string("turntable/") + name).c_str(), turntable, coherence)
            ->Unit(benchmark::kSecond)
            ->UseRealTime()
            ->MeasureProcessCPUTime();
    return true;
}();

}  // namespace
