#include "app/cli/farm/farm_command.h"
#include "app/cli/overwrite_flag.h"
#include "core/base/color.h"
#include "core/base/error.h"
#include "core/export/sequence_check.h"
#include "core/export/video.h"

#include <spdlog/fmt/fmt.h>

#include <memory>

namespace chiaro::cli::farm {

namespace {

using exporting::FrameRange;
using exporting::FrameSequence;

struct CollectCommand {
    std::string name;
    std::string frames;
    std::filesystem::path video;
    std::string background = "#ffffff";
    std::optional<double> framesPerSecond;
    OverwriteFlag overwrite;

    /// What is collected.
    struct Frames {
        FrameSequence sequence;
        FrameRange range;
        double rate;
    };

    void run(Session& session) const {
        usageFrom("--background", [this] { colorFromHex(background); });
        if (!video.empty() && !exporting::isWritableVideo(video))
            throw CLI::ValidationError("--video: is no video; name a .mp4, .webm or .mkv");
        const Frames found = framesNamed();
        if (!video.empty()) overwrite.check({video});
        const Task task = session.task("collect");
        const exporting::SequenceReport report =
            exporting::checkSequence(found.sequence, found.range, task.part(0, video.empty() ? 1 : 0.3));
        if (!report.isWhole())
            throw Error(name, report.text(), "see farm status, and submit again with --resume");
        if (!video.empty()) makeVideo(found, task.part(0.3, 1));
        task.report(1);
        session.finish(
            {{"frames", found.range.count()}, {"video", video.string()}},
            fmt::format(
                "{}: {} frames, all there and whole{}", name, found.range.count(),
                video.empty() ? "" : fmt::format("; {} at {:g} a second", video.string(), found.rate)));
    }

    /// Of a job, or of a pattern and --frames.
    Frames framesNamed() const {
        std::optional<FrameRange> range;
        if (!frames.empty()) usageFrom("--frames", [&] { range = FrameRange::parse(frames); });
        if (range && name.find('#') != std::string::npos)
            return {FrameSequence(name), *range, framesPerSecond.value_or(24)};
        const Job job = jobNamed(name);
        return {FrameSequence(job.pattern), range.value_or(job.range()), framesPerSecond.value_or(job.rate)};
    }

    void makeVideo(const Frames& found, const Task& task) const {
        const glm::vec3 color = colorFromHex(background);
        std::optional<exporting::VideoWriter> writer;
        for (int frame = found.range.first; frame <= found.range.last; ++frame) {
            const ColorImage picture = exporting::readFrame(found.sequence.path(frame), color);
            if (!writer) writer.emplace(video, picture.width(), picture.height(), found.rate);
            writer->add(picture);
            task.report(double(frame - found.range.first + 1) / found.range.count());
            task.checkpoint();
        }
        writer->finish();
    }
};

}  // namespace

void addCollectCommand(CLI::App& farm, Session& session) {
    CLI::App* command = farm.add_subcommand(
        "collect", "See whether all frames are there, whole, and of one command; make a video of them");
    auto state = std::make_shared<CollectCommand>();
    command
        ->add_option("JOB", state->name,
                     "The job's folder or number, or name.####.png of any sequence with --frames")
        ->required();
    command->add_option("--frames", state->frames, "First and last frame, as 1-48 (default: the job's)");
    command->add_option("--video", state->video, "Video to make of them: .mp4, .webm or .mkv (lossless)");
    command
        ->add_option("--fps", state->framesPerSecond,
                     "Frames a second of the video (1..240; default: the job's, or 24)")
        ->check(CLI::Range(1.0, 240.0));
    command->add_option("--background", state->background,
                        "#rrggbb behind transparent frames in the video (default #ffffff)");
    state->overwrite.addTo(*command);
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli::farm
