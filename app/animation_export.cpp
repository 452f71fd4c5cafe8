#include "app/animation_export.h"

#include "core/base/error.h"
#include "core/base/image_io.h"
#include "core/export/frame_sequence.h"
#include "core/export/video.h"
#include "core/project/animation.h"

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

void writeVideo(const project::Shot& shot, const AnimationSettings& settings, const Task& task) {
    const project::Animation& animation = shot.project.animation;
    exporting::VideoWriter video(settings.output, shot.width, shot.height, animation.rate);
    project::ShotViews views(shot);
    const auto painter = project::framePainter(shot, views);
    const double count = animation.lastFrame - animation.firstFrame + 1;
    for (int frame = animation.firstFrame; frame <= animation.lastFrame; ++frame) {
        const double done = (frame - animation.firstFrame) / count;
        const methods::Frame painted = painter->paint(frame, task.part(done, done + 1 / count)).frame;
        video.add(methods::over(painted.picture, settings.background));
    }
    video.finish();
}

void writePictures(const project::Shot& shot, const AnimationSettings& settings, const Task& task) {
    const project::Animation& animation = shot.project.animation;
    const exporting::FrameSequence sequence(settings.output);
    const ImageMetadata metadata{{"Software", "Chiaro " CHIARO_VERSION}};
    project::ShotViews views(shot);
    const auto painter = project::framePainter(shot, views);
    const double count = animation.lastFrame - animation.firstFrame + 1;
    for (int frame = animation.firstFrame; frame <= animation.lastFrame; ++frame) {
        const double done = (frame - animation.firstFrame) / count;
        const methods::Frame painted = painter->paint(frame, task.part(done, done + 1 / count)).frame;
        task.checkpoint();
        if (settings.transparent)
            writeImage(sequence.path(frame), painted.picture, metadata, PixelDepth::Bits8);
        else
            writeImage(sequence.path(frame), methods::over(painted.picture, settings.background), metadata,
                       PixelDepth::Bits8);
    }
}

}  // namespace

void checkAnimationOutput(const std::filesystem::path& output) {
    if (!exporting::isWritableVideo(output)) exporting::FrameSequence sequence(output);
}

void exportAnimation(const project::Project& project, const scene::Scene& scene,
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
    if (exporting::isWritableVideo(settings.output))
        writeVideo(shot, settings, task.part(0.3, 1));
    else
        writePictures(shot, settings, task.part(0.3, 1));
}

}  // namespace chiaro::app
