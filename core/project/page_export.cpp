#include "core/project/page_export.h"

#include "core/base/error.h"
#include "core/export/relightable_page.h"

#include <algorithm>
#include <chrono>
#include <set>

namespace chiaro::project {

namespace {

double secondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// One a sample; those that nothing visible wears are empty.
std::vector<Paint> wornSamples(const Project& project, const scene::Scene& scene, const Task& task) {
    std::set<int> worn;
    for (const scene::Object& object : scene.objects)
        if (object.visible && object.mesh) worn.insert(object.sample);
    if (worn.empty()) throw Error("scene", "shows no object", "make at least one object visible");
    if (*worn.rbegin() >= int(project.samples.size()))
        throw Error("scene", "has no paint sample", "add a scan of paint");
    std::vector<Paint> paints(project.samples.size());
    const double share = 1 / double(worn.size());
    double done = 0;
    for (const int sample : worn) {
        paints[std::size_t(sample)] = preparePaint(project.samples[std::size_t(sample)], project.levels,
                                                   task.part(share * done, share * (done + 1)));
        ++done;
    }
    return paints;
}

exporting::PageScene pageScene(const Project& project, const scene::Scene& scene, const WornPaints& worn) {
    exporting::PageScene page;
    page.lights = scene.lights;
    page.method = project.method;
    page.viewAligned = project.viewAligned;
    page.viewDependent = project.viewDependent;
    std::vector<const Paint*> paints;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object& object = scene.objects[i];
        if (!object.visible || !object.mesh) continue;
        auto paint = std::ranges::find(paints, worn[i].paint);
        if (paint == paints.end()) {
            page.paints.push_back({&worn[i].paint->shown, &worn[i].paint->levels});
            paint = paints.insert(paints.end(), worn[i].paint);
        }
        page.objects.push_back(
            {object.name, object.mesh, object.transform, std::size_t(paint - paints.begin()), worn[i].views});
    }
    return page;
}

}  // namespace

ExportedPage exportPage(const std::filesystem::path& path, const std::string& title, const Project& project,
                        const scene::Scene& scene, const scene::Camera& camera, const ImageMetadata& metadata,
                        const Task& task, const TextureCache* cache) {
    exporting::checkPageProgram();
    ExportedPage result;
    auto begin = std::chrono::steady_clock::now();
    const std::vector<Paint> paints = wornSamples(project, scene, task.part(0, 0.2));
    Project viewDependent = project;
    viewDependent.method = "view-dependent";
    const WornPaints worn = wornPaints(viewDependent, scene, paints, task.part(0.2, 0.8), cache);
    result.synthesisSeconds = secondsSince(std::exchange(begin, std::chrono::steady_clock::now()));
    exporting::PageScene page = pageScene(project, scene, worn);
    page.title = title;
    page.camera = camera;
    result.html = exporting::pageBytes(path, page, metadata, task.part(0.8, 1));
    result.writeSeconds = secondsSince(begin);
    result.objects = page.objects.size();
    for (const exporting::PageObject& object : page.objects) result.faces += object.mesh->triangles.size();
    return result;
}

}  // namespace chiaro::project
