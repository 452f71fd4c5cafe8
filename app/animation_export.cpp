#include "app/animation_export.h"

#include "core/base/color.h"
#include "core/base/error.h"
#include "core/project/picture_parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace chiaro::app {

namespace {

std::vector<project::Paint> paintsOf(const project::Project& project, const Task& task) {
    std::vector<project::Paint> paints;
    const double share = 1 / double(project.samples.size());
    for (std::size_t i = 0; i < project.samples.size(); ++i)
        paints.push_back(
            project::preparePaint(project, i, task.part(share * double(i), share * double(i + 1))));
    return paints;
}

/// What every frame tells of how it was made.
std::function<ImageMetadata(int)> metadataOf(const project::Shot& shot, const AnimationSettings& settings) {
    nlohmann::json json = project::paintParameters(shot.project);
    json.update(parametersToJson(shot.project.coherence));
    json.update(project::sceneParameters(shot.project));
    json["size"] = {settings.width, settings.height};
    json["background"] = settings.transparent ? "transparent" : hexFromColor(settings.background);
    json["path"] = "project";
    json["content"] = project::contentHash(shot);
    return [json](int frame) {
        nlohmann::json ofFrame = json;
        ofFrame["frame"] = frame;
        return ImageMetadata{{"Software", "Chiaro " CHIARO_VERSION},
                             {"chiaro:command", "animate"},
                             {"chiaro:parameters", ofFrame.dump()}};
    };
}

}  // namespace

project::AnimationOutput outputOf(const project::Animation& animation, const AnimationSettings& settings) {
    project::AnimationOutput output;
    output.path = settings.output;
    output.range = {animation.firstFrame, animation.lastFrame};
    output.rate = animation.rate;
    if (output.isVideo() || !settings.transparent) output.background = settings.background;
    if (output.isVideo()) return output;
    output.resume = settings.resume;
    if (!settings.withValues) return output;
    const std::string name = settings.output.filename().string();
    output.auxiliary = exporting::AuxiliaryFolder(settings.output.parent_path() /
                                                  (name.substr(0, name.find('.')) + " values"));
    return output;
}

int exportAnimation(const project::Project& project, const scene::Scene& scene,
                    const AnimationSettings& settings, const Task& task) {
    if (project.samples.empty())
        throw Error("animation", "has no paint", "open a strip that its objects can wear");
    scene::Scene present = scene;
    std::erase_if(present.objects, [](const scene::Object& object) { return !object.mesh; });
    const std::vector<project::Paint> paints = paintsOf(project, task.part(0, 0.1));
    const project::TextureCache cache(project::TextureCache::standardFolder());
    const project::WornPaints worn =
        project::wornPaints(project, present, paints, task.part(0.1, 0.3), &cache);
    const project::Shot shot{project, present, worn, project.animation.path, settings.width, settings.height};
    project::AnimationOutput output = outputOf(project.animation, settings);
    output.metadata = metadataOf(shot, settings);
    return project::writeAnimation(shot, output, task.part(0.3, 1));
}

}  // namespace chiaro::app
