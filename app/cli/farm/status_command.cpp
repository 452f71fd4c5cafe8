#include "app/cli/farm/farm_command.h"
#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>

#include <memory>
#include <thread>

namespace chiaro::cli::farm {

namespace {

/// How a chunk stands.
struct Standing {
    const char* state;  ///< waiting, running, done, failed, or lost: it neither ended nor goes on
    int tries = 0;
    int status = 0;
    int finished = 0;  ///< frames that are there
};

struct Overview {
    std::vector<Standing> chunks;
    int finished = 0;
    int failed = 0;  ///< chunks that failed or are lost
    bool goesOn = false;
};

Standing standingOf(const std::optional<Note>& note, const Queued* queued) {
    Standing standing{"lost"};
    if (note) standing.tries = note->tries;
    if (note) standing.status = note->status;
    if (queued)
        standing.state = *queued == Queued::Running ? "running" : "waiting";
    else if (note && note->kind == Note::Kind::Done)
        standing.state = "done";
    else if (note && note->kind == Note::Kind::Failed)
        standing.state = "failed";
    return standing;
}

Overview overviewOf(const Job& job) {
    const std::map<int, Queued> queue = engine(job.engine).queue(job);
    const exporting::FrameSequence sequence(job.pattern);
    Overview overview;
    for (int chunk = 1; chunk <= int(job.chunks.size()); ++chunk) {
        const auto queued = queue.find(chunk);
        Standing standing = standingOf(noteOf(job, chunk), queued == queue.end() ? nullptr : &queued->second);
        const exporting::FrameRange frames = job.chunks[std::size_t(chunk) - 1];
        std::error_code ignored;
        for (int frame = frames.first; frame <= frames.last; ++frame)
            standing.finished += std::filesystem::exists(sequence.path(frame), ignored);
        overview.finished += standing.finished;
        overview.failed += standing.state == std::string("failed") || standing.state == std::string("lost");
        overview.goesOn = overview.goesOn || queued != queue.end();
        overview.chunks.push_back(standing);
    }
    return overview;
}

nlohmann::json jsonOf(const Job& job, const Overview& overview) {
    nlohmann::json json{{"job", job.number},
                        {"engine", job.engine},
                        {"folder", job.folder.string()},
                        {"frames", job.range().count()},
                        {"finished", overview.finished},
                        {"failed", overview.failed}};
    for (std::size_t i = 0; i < overview.chunks.size(); ++i) {
        const Standing& one = overview.chunks[i];
        json["chunks"].push_back({{"frames", fmt::format("{}-{}", job.chunks[i].first, job.chunks[i].last)},
                                  {"state", one.state},
                                  {"tries", one.tries},
                                  {"status", one.status},
                                  {"finished", one.finished}});
    }
    return json;
}

std::string textOf(const Job& job, const Overview& overview) {
    std::string text = fmt::format("job {} on {}: {} of {} frames", job.number, job.engine, overview.finished,
                                   job.range().count());
    for (std::size_t i = 0; i < overview.chunks.size(); ++i) {
        const Standing& one = overview.chunks[i];
        const exporting::FrameRange frames = job.chunks[i];
        text += fmt::format("\n{:>4}  {:<13} {:<8} {:>4} of {:<4}", i + 1,
                            fmt::format("{}-{}", frames.first, frames.last), one.state, one.finished,
                            frames.count());
        if (one.tries > 1) text += fmt::format("  try {} of {}", one.tries, job.tries);
        if (one.state == std::string("failed"))
            text += fmt::format("  exit status {}, see {}", one.status, job.log(int(i) + 1).string());
    }
    return text;
}

struct StatusCommand {
    std::string name;
    bool waits = false;

    void run(Session& session) const {
        const Job job = jobNamed(name);
        Overview overview = overviewOf(job);
        const Task task = session.task("farm");
        while (waits && overview.goesOn) {
            task.report(double(overview.finished) / job.range().count());
            for (int i = 0; i < 20; ++i) {
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
                task.checkpoint();
            }
            overview = overviewOf(job);
        }
        session.finish(jsonOf(job, overview), textOf(job, overview));
        if (waits && overview.failed > 0)
            throw Error(job.folder.string(), fmt::format("{} of its chunks failed", overview.failed),
                        "read its logs and submit it again with --resume");
    }
};

}  // namespace

void addStatusCommand(CLI::App& farm, Session& session) {
    CLI::App* command =
        farm.add_subcommand("status", "How far a job is: each chunk's state, tries and finished frames");
    auto state = std::make_shared<StatusCommand>();
    command
        ->add_option("JOB", state->name,
                     "The job's folder, name.####.png of its frames, or its number while Slurm knows it")
        ->required();
    command->add_flag("--wait", state->waits, "Wait until it is over; exit status 1 when a chunk failed");
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli::farm
