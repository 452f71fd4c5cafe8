#include "core/project/pipeline.h"

#include <chrono>

namespace chiaro::project {

gradient::Gradient shownGradient(const Sample& sample, const gradient::Separation& separation) {
    if (!sample.recoloring) return separation.gradient;
    return sample.recoloring->sampled(int(separation.gradient.size()));
}

Paint preparePaint(const Sample& sample, const synthesis::LevelParams& levels, const Task& task) {
    Paint paint;
    paint.strip = sample::readStrip(sample.scan, sample.strip);
    task.checkpoint();
    paint.separation = gradient::separate(paint.strip, sample.gradient, task.part(0, 0.2));
    paint.shown = shownGradient(sample, paint.separation);
    const auto begin = std::chrono::steady_clock::now();
    paint.levels = synthesis::makeLevels(paint.strip, paint.separation.gradient, levels, task.part(0.2, 1));
    paint.levelSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return paint;
}

scene::Scene makeScene(const Project& project,
                       const std::vector<std::shared_ptr<const scene::Mesh>>& meshes) {
    scene::Scene scene;
    scene.lights = project.lights;
    for (const auto& mesh : meshes) {
        scene::Object object{.name = mesh->name, .mesh = mesh};
        const auto settings = std::find_if(project.objects.begin(), project.objects.end(),
                                           [&](const ObjectSettings& one) { return one.name == mesh->name; });
        if (settings != project.objects.end()) {
            object.transform = settings->transform;
            object.sample = settings->sample;
            object.visible = settings->visible;
        }
        scene.objects.push_back(std::move(object));
    }
    return scene;
}

scene::Camera cameraFor(const Project& project, const scene::Scene& scene) {
    return project.frameCamera ? project.camera.framed(boundsOf(scene)) : project.camera;
}

methods::Frame renderFrame(const Project& project, const scene::Scene& scene,
                           const std::vector<Paint>& paints, const scene::GBuffer& gbuffer,
                           const Task& task) {
    std::vector<methods::ViewAlignedPaint> worn;
    for (const scene::Object& object : scene.objects) {
        const Paint& paint = paints[std::size_t(object.sample)];
        worn.push_back({&paint.levels, &paint.shown, {}});
    }
    return methods::renderViewAligned(gbuffer, worn, project.viewAligned, task);
}

}  // namespace chiaro::project
