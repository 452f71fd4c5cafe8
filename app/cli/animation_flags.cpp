#include "app/cli/animation_flags.h"

#include "core/base/atomic_file.h"

#include <spdlog/fmt/fmt.h>

namespace chiaro::cli {

using exporting::FrameRange;

namespace {

void addCoherenceFlags(CLI::App& command,
                       std::vector<std::function<void(methods::CoherenceParams&)>>& assignments) {
    const auto& table = methods::CoherenceParams::table();
    addParameterFlags(command, table.specs(), table.values({}),
                      [&assignments, &table](std::size_t index, double value) {
                          assignments.push_back([&table, index, value](auto& params) {
                              std::vector<double> values = table.values(params);
                              values[index] = value;
                              table.assign(params, values);
                          });
                      });
}

}  // namespace

void AnimationFlags::addTo(CLI::App& command) {
    m_source.addTo(command);
    command
        .add_option("-o,--output", m_output,
                    "Pictures to write, name.####.png (.exr, .tif), #### being the frame; or a video: .mp4, "
                    ".webm or .mkv (lossless)")
        ->required();
    command.add_option(
        "--frames", m_frames,
        "First and last frame, as 1-48 (default: the project's render range if its timeline has keys, else "
        "1-48); any part of a path gives the frames that the whole path gives");
    m_path.addTo(command, "the keys of the project's timeline, or turntable if it has none");
    addCoherenceFlags(command, m_coherence);
    command
        .add_option("--fps", m_framesPerSecond,
                    "Frames a second of a video (1..240; default: the project's, or 24)")
        ->check(CLI::Range(1.0, 240.0));
    command.add_flag("--resume", m_resume,
                     "Keep pictures that are there already and were made by the same command from the same "
                     "files; make the others anew");
    m_overwrite.addTo(command);
    m_picture.addTo(command);
}

void AnimationFlags::check() const {
    m_picture.check();
    range({});
    if (!makesVideo()) return usageFrom("--output", [this] { project::checkAnimationPath(m_output); });
    if (m_picture.isTransparent())
        throw CLI::ValidationError("--background: is transparent, which videos can't be; choose a colour");
    if (m_picture.auxiliary().isGiven())
        throw CLI::ValidationError("--aux: is for sequences of pictures; write name.####.png");
    if (m_resume)
        throw CLI::ValidationError(
            "--resume: is for sequences of pictures; write name.####.png, and make the video of them with "
            "farm collect --video");
}

project::Project AnimationFlags::load() const {
    project::Project project = m_source.load();
    m_path.checkPeriod(isKeyed(project.animation));
    if (!m_coherence.empty() && !m_source.methodGiven()) project.method = "image-based";
    for (const auto& apply : m_coherence) apply(project.coherence);
    return project;
}

FrameRange AnimationFlags::range(const project::Animation& animation) const {
    FrameRange range{1, 48};
    if (!m_frames.empty())
        usageFrom("--frames", [&] { range = FrameRange::parse(m_frames); });
    else if (isKeyed(animation))
        range = {animation.firstFrame, animation.lastFrame};
    return range;
}

bool AnimationFlags::isKeyed(const project::Animation& animation) const {
    return !m_path.isGiven() && animation.path.moves();
}

scene::Path AnimationFlags::path(const project::Animation& animation) const {
    return isKeyed(animation) ? animation.path : m_path.path();
}

project::AnimationOutput AnimationFlags::output(const project::Project& project) const {
    project::AnimationOutput output;
    output.path = m_output;
    output.range = range(project.animation);
    output.background = m_picture.background();
    output.auxiliary = m_picture.auxiliary();
    output.rate = m_framesPerSecond.value_or(project.animation.rate);
    output.resume = m_resume;
    return output;
}

void AnimationFlags::describe(project::AnimationOutput& output, const project::Shot& shot) const {
    nlohmann::json json = m_picture.parameters();
    json.update(paintParameters(shot.project));
    json.update(parametersToJson(shot.project.coherence));
    json.update(sceneParameters(shot.project));
    if (isKeyed(shot.project.animation))
        json["path"] = "project";
    else
        json.update(m_path.parameters());
    json["content"] = fmt::format("{:016x}", project::contentHash(shot));
    output.metadata = [json](int frame) {
        nlohmann::json ofFrame = json;
        ofFrame["frame"] = frame;
        return pictureMetadata("animate", ofFrame);
    };
}

void AnimationFlags::checkFiles(const project::Project& project,
                                const project::AnimationOutput& output) const {
    std::vector<std::filesystem::path> inputs{m_source.path(), m_path.name()};
    for (const project::MeshFile& mesh : project.meshes) inputs.push_back(mesh.path);
    for (const project::Sample& sample : project.samples) inputs.push_back(sample.scan);
    const std::vector<std::filesystem::path> outputs = output.files();
    refuseOverwriting(inputs, outputs);
    if (m_resume)
        checkOutputs(outputs, true);
    else
        m_overwrite.check(outputs, makesVideo() ? "" : "--resume to keep finished frames");
}

}  // namespace chiaro::cli
