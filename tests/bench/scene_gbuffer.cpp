// G-buffer of half a million faces at 1024 x 1024. "Cast" is what a frame costs; "Build" the acceleration
// structure, once a scene. "CastCentresOnly" casts nothing but one ray a pixel on the same scene, so Cast /
// CastCentresOnly is what looking for and smoothing the silhouettes costs.

#include "core/scene/gbuffer.h"
#include "core/scene/ray_scene.h"
#include "tests/core/scene/shapes.h"

#include <benchmark/benchmark.h>
#include <tbb/parallel_for.h>

namespace chiaro {
namespace {

constexpr int size = 1024;

/// 22 bumpy balls on a grid, 502,656 faces in all.
scene::Scene manyFaces() {
    std::vector<scene::Mesh> meshes;
    for (int i = 0; i < 22; ++i) {
        scene::Mesh mesh = test::ball(128, 90);
        for (glm::vec3& position : mesh.positions)
            position *= 1 + 0.08f * std::sin(9 * position.x) * std::sin(11 * position.y + float(i));
        mesh.normals = scene::angleWeightedNormals(mesh);
        meshes.push_back(std::move(mesh));
    }
    scene::Scene scene = test::sceneOf(std::move(meshes));
    for (int i = 0; i < 22; ++i)
        scene.objects[std::size_t(i)].transform[3] = glm::vec4(float(i % 5) * 2, float(i / 5) * 2, 0, 1);
    return scene;
}

void Build(benchmark::State& state) {
    const scene::Scene scene = manyFaces();
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(scene::RayScene(scene));
}
BENCHMARK(Build)->Unit(benchmark::kMillisecond)->UseRealTime();

void Cast(benchmark::State& state) {
    const scene::Scene scene = manyFaces();
    const scene::RayScene rays(scene);
    const scene::Camera camera = scene::Camera{}.framed(boundsOf(scene));
    std::size_t edges = 0;
    for ([[maybe_unused]] auto _ : state)
        edges = scene::castGBuffer(rays, scene.lights, camera, size, size).edgePixels.size();
    state.counters["edge share"] = double(edges) / (size * size);
}
BENCHMARK(Cast)->Unit(benchmark::kMillisecond)->UseRealTime();

void CastCentresOnly(benchmark::State& state) {
    const scene::Scene scene = manyFaces();
    const scene::RayScene rays(scene);
    const scene::RayCaster caster(rays.impl(), scene::Camera{}.framed(boundsOf(scene)), size, size);
    for ([[maybe_unused]] auto _ : state)
        tbb::parallel_for(0, size / 4, [&](int row) {
            std::array<glm::vec2, scene::packetSize> positions;
            std::array<scene::Hit, scene::packetSize> hits;
            for (int x = 0; x < size; x += 4) {
                for (int i = 0; i < scene::packetSize; ++i)
                    positions[std::size_t(i)] = glm::vec2(x + i % 4, row * 4 + i / 4) + 0.5f;
                caster.cast(positions, hits);
                benchmark::DoNotOptimize(hits);
            }
        });
}
BENCHMARK(CastCentresOnly)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace chiaro
