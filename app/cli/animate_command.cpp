#include "app/cli/path_flags.h"
#include "app/cli/picture_output.h"
#include "app/cli/project_source.h"
#include "core/base/error.h"
#include "core/export/frame_sequence.h"
#include "core/export/video.h"
#include "core/project/animation.h"
#include "core/scene/motion.h"

#include <spdlog/fmt/fmt.h>

#include <memory>
#include <optional>

namespace chiaro::cli {

namespace {

using exporting::FrameRange;
using exporting::FrameSequence;
using exporting::VideoWriter;

/// True when the file holds a whole picture of this size that was made by the same command.
bool isFinished(const std::filesystem::path& path, const ImageMetadata& metadata, glm::ivec2 size) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return false;
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

struct AnimateCommand {
    ProjectSource source;
    PictureOutput picture;
    methods::CoherenceParams coherence;
    std::vector<std::function<void(methods::CoherenceParams&)>> coherenceFlags;
    std::filesystem::path output;
    std::string frames;  ///< empty: the project's, where something moves in it
    PathFlags path{"turntable"};
    std::optional<double> framesPerSecond;
    bool resume = false;

    bool makesVideo() const { return exporting::isWritableVideo(output); }

    void run(Session& session) const {
        session.start();
        checkFlags();
        rangeOf({});
        const Task task = session.task("animate");
        project::Project project = source.load();
        path.checkPeriod(keyed(project.animation));
        const FrameRange range = rangeOf(project.animation);
        if (!coherenceFlags.empty() && !source.methodGiven()) project.method = "image-based";
        for (const auto& apply : coherenceFlags) apply(project.coherence);
        const scene::Path way = keyed(project.animation) ? project.animation.path : path.path();
        refuseInputs(project, range);
        Stopwatch stopwatch;
        const LoadedProject loaded = loadProject(std::move(project), task.part(0, 0.1));
        const project::TextureCache cache(project::TextureCache::standardFolder());
        const project::WornPaints worn =
            project::wornPaints(loaded.project, loaded.scene, loaded.paints, task.part(0.1, 0.3), &cache);
        const glm::ivec2 size = picture.size();
        const project::Shot shot{loaded.project, loaded.scene, worn, way, size.x, size.y};
        const int resumed = makesVideo() ? makeVideo(shot, range, task.part(0.3, 1))
                                         : makeFrames(shot, range, task.part(0.3, 1));
        const double seconds = stopwatch.lap();
        session.finish({{"frames", range.count()}, {"seconds", seconds}, {"resumed", resumed}},
                       fmt::format("{}: {} frames{}{}, {:.2f} s", output.string(), range.count(),
                                   resumed > 0 ? fmt::format(", {} of them finished before", resumed) : "",
                                   padding(size), seconds));
    }

    /// Videos take even sides only.
    std::string padding(glm::ivec2 size) const {
        const glm::ivec2 even = (size + 1) / 2 * 2;
        if (!makesVideo() || even == size) return {};
        return fmt::format(", padded to {} x {} px, since videos have even sides", even.x, even.y);
    }

    void checkFlags() const {
        picture.check();
        if (!makesVideo()) {
            usageFrom("--output", [this] { FrameSequence{output}; });
            return;
        }
        if (picture.isTransparent())
            throw CLI::ValidationError(
                "--background: is transparent, which videos can't be; choose a colour");
        if (resume) throw CLI::ValidationError("--resume: is for sequences of pictures; write name.####.png");
    }

    FrameRange rangeOf(const project::Animation& animation) const {
        FrameRange range{1, 48};
        if (!frames.empty())
            usageFrom("--frames", [&] { range = FrameRange::parse(frames); });
        else if (keyed(animation))
            range = {animation.firstFrame, animation.lastFrame};
        return range;
    }

    /// Whether the project's keys are to be followed.
    bool keyed(const project::Animation& animation) const {
        return !path.isGiven() && animation.path.moves();
    }

    void refuseInputs(const project::Project& project, FrameRange range) const {
        std::vector<std::filesystem::path> inputs{source.path(), path.name()};
        for (const project::MeshFile& mesh : project.meshes) inputs.push_back(mesh.path);
        for (const project::Sample& sample : project.samples) inputs.push_back(sample.scan);
        if (makesVideo()) return refuseOverwriting(inputs, {output});
        for (int frame = range.first; frame <= range.last; ++frame)
            refuseOverwriting(inputs, {FrameSequence(output).path(frame)});
    }

    ImageMetadata metadata(const project::Shot& shot, std::uint64_t content, int frame) const {
        nlohmann::json json = picture.parameters();
        json.update(paintParameters(shot.project));
        json.update(parametersToJson(shot.project.coherence));
        json.update(sceneParameters(shot.project));
        if (keyed(shot.project.animation))
            json["path"] = "project";
        else
            json.update(path.parameters());
        json["frame"] = frame;
        json["content"] = fmt::format("{:016x}", content);
        return pictureMetadata("animate", json);
    }

    /// Returns how many frames were finished before.
    int makeFrames(const project::Shot& shot, FrameRange range, const Task& task) const {
        const FrameSequence sequence(output);
        const std::uint64_t content = project::contentHash(shot);
        project::ShotViews views(shot);
        const auto painter = project::framePainter(shot, views);
        int resumed = 0;
        for (int frame = range.first; frame <= range.last; ++frame) {
            const ImageMetadata made = metadata(shot, content, frame);
            if (resume && isFinished(sequence.path(frame), made, {shot.width, shot.height})) {
                ++resumed;
                continue;
            }
            const project::Rendering rendering = painter->paint(frame, partOf(task, range, frame));
            if (picture.writesAuxiliary()) writeAuxiliary(shot, views, frame, rendering.frame, made);
            picture.write(sequence.path(frame), rendering.frame.picture, made);
        }
        task.report(1);
        return resumed;
    }

    int makeVideo(const project::Shot& shot, FrameRange range, const Task& task) const {
        VideoWriter video(output, shot.width, shot.height,
                          framesPerSecond.value_or(shot.project.animation.rate));
        project::ShotViews views(shot);
        const auto painter = project::framePainter(shot, views);
        for (int frame = range.first; frame <= range.last; ++frame)
            video.add(picture.opaque(painter->paint(frame, partOf(task, range, frame)).frame.picture));
        video.finish();
        task.report(1);
        return 0;
    }

    static Task partOf(const Task& task, FrameRange range, int frame) {
        const double begin = double(frame - range.first) / range.count();
        return task.part(begin, begin + 1.0 / range.count());
    }

    /// What render writes, and the motion to the next frame.
    void writeAuxiliary(const project::Shot& shot, project::ShotViews& views, int frame,
                        const methods::Frame& painted, const ImageMetadata& metadata) const {
        const methods::FrameView view = views.at(frame);
        picture.writeAuxiliary(*view.gbuffer, painted, metadata, frame);
        writeImage(picture.auxiliaryPath("motion", ".exr", frame),
                   scene::screenMotion(*view.gbuffer, view.camera, shot.view(frame + 1).camera), metadata);
    }
};

void addCoherenceFlags(CLI::App& command, AnimateCommand& state) {
    const auto& table = methods::CoherenceParams::table();
    addParameterFlags(command, table.specs(), table.values(state.coherence),
                      [&state, &table](std::size_t index, double value) {
                          state.coherenceFlags.push_back([&table, index, value](auto& params) {
                              std::vector<double> values = table.values(params);
                              values[index] = value;
                              table.assign(params, values);
                          });
                      });
}

}  // namespace

void addAnimateCommand(CLI::App& root, Session& session) {
    CLI::App* command = root.add_subcommand(
        "animate", "Paint the frames of a moving view as a sequence of pictures or a video (§4.1)");
    auto state = std::make_shared<AnimateCommand>();
    state->source.addTo(*command);
    command
        ->add_option("-o,--output", state->output,
                     "Pictures to write, name.####.png (.exr, .tif), #### being the frame; or a video: .mp4, "
                     ".webm or .mkv (lossless)")
        ->required();
    command->add_option(
        "--frames", state->frames,
        "First and last frame, as 1-48 (default: the project's render range if its timeline has keys, else "
        "1-48); any part of a path gives the frames that the whole path gives");
    state->path.addTo(*command, "the keys of the project's timeline, or turntable if it has none");
    addCoherenceFlags(*command, *state);
    command
        ->add_option("--fps", state->framesPerSecond,
                     "Frames a second of a video (1..240; default: the project's, or 24)")
        ->check(CLI::Range(1.0, 240.0));
    command->add_flag("--resume", state->resume,
                      "Keep pictures that are there already and were made by the same command from the same "
                      "files");
    state->picture.addTo(*command);
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli
