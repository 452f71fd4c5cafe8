#include "core/project/animation_output.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/export/video.h"
#include "core/scene/motion.h"

#include <algorithm>

namespace chiaro::project {

namespace fs = std::filesystem;

namespace {

Task partOf(const Task& task, exporting::FrameRange range, int frame) {
    const double begin = double(frame - range.first) / range.count();
    return task.part(begin, begin + 1.0 / range.count());
}

/// The files of a frame, its picture last: where that is there, the others are.
std::vector<fs::path> filesOf(const AnimationOutput& output, int frame) {
    std::vector<fs::path> files = output.auxiliary.ofFrame(frame);
    files.push_back(exporting::FrameSequence(output.path).path(frame));
    return files;
}

void writeFrame(const Shot& shot, ShotViews& views, const AnimationOutput& output, int frame,
                const methods::Frame& painted) {
    const ImageMetadata metadata = output.metadata(frame);
    if (output.auxiliary.isGiven()) {
        const methods::FrameView view = views.at(frame);
        output.auxiliary.write(*view.gbuffer, painted, metadata, frame);
        output.auxiliary.writeMotion(
            scene::screenMotion(*view.gbuffer, view.camera, shot.view(frame + 1).camera), metadata, frame);
    }
    exporting::writePainted(exporting::FrameSequence(output.path).path(frame), painted.picture,
                            output.background, metadata);
}

int writePictures(const Shot& shot, const AnimationOutput& output, const Task& task) {
    ShotViews views(shot);
    const auto painter = framePainter(shot, views);
    if (output.resume) removeLeftovers(output.files());
    int resumed = 0;
    for (int frame = output.range.first; frame <= output.range.last; ++frame) {
        const auto isFinished = [&](const fs::path& file) {
            return isFinishedPicture(file, output.metadata(frame), {shot.width, shot.height});
        };
        if (output.resume && std::ranges::all_of(filesOf(output, frame), isFinished)) {
            ++resumed;
            task.checkpoint();
            continue;
        }
        const Rendering rendering = painter->paint(frame, partOf(task, output.range, frame));
        task.checkpoint();
        writeFrame(shot, views, output, frame, rendering.frame);
    }
    return resumed;
}

void writeVideo(const Shot& shot, const AnimationOutput& output, const Task& task) {
    exporting::VideoWriter video(output.path, shot.width, shot.height, output.rate);
    ShotViews views(shot);
    const auto painter = framePainter(shot, views);
    const glm::vec3 background = output.background.value_or(glm::vec3(1));
    for (int frame = output.range.first; frame <= output.range.last; ++frame) {
        const methods::Frame painted = painter->paint(frame, partOf(task, output.range, frame)).frame;
        task.checkpoint();
        video.add(methods::over(painted.picture, background));
    }
    video.finish();
}

}  // namespace

bool AnimationOutput::isVideo() const {
    return exporting::isWritableVideo(path);
}

std::vector<fs::path> AnimationOutput::files() const {
    if (isVideo()) return {path};
    std::vector<fs::path> files;
    for (int frame = range.first; frame <= range.last; ++frame)
        std::ranges::move(filesOf(*this, frame), std::back_inserter(files));
    return files;
}

void checkAnimationPath(const fs::path& path) {
    if (!exporting::isWritableVideo(path)) exporting::FrameSequence sequence(path);
}

bool isFinishedPicture(const fs::path& path, const ImageMetadata& metadata, glm::ivec2 size) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) return false;
    try {
        const ImageMetadata found = readImageMetadata(path);
        for (const auto& [key, value] : metadata) {
            const auto entry = found.find(key);
            if (entry == found.end() || entry->second != value) return false;
        }
        const DecodedImage picture = readImage(path, {.mayBeNotFinite = true});
        return glm::ivec2(picture.width, picture.height) == size;
    } catch (const Error&) {
        return false;  // damaged or cut off: made again
    }
}

int writeAnimation(const Shot& shot, const AnimationOutput& output, const Task& task) {
    int resumed = 0;
    if (output.isVideo())
        writeVideo(shot, output, task);
    else
        resumed = writePictures(shot, output, task);
    task.report(1);
    return resumed;
}

}  // namespace chiaro::project
