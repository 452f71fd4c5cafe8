#include "app/cli/animation_flags.h"
#include "app/cli/farm/farm_command.h"
#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <memory>

namespace chiaro::cli::farm {

namespace {

namespace fs = std::filesystem;

struct SubmitCommand {
    AnimationFlags flags;
    std::vector<CLI::Option*> passedOn;  ///< flags of animate that every chunk is given
    fs::path folder;
    std::string engineKey = "slurm";
    int chunk = 24;
    int tries = 3;
    Terms terms;
    bool isDry = false;

    void run(Session& session) const {
        flags.check();
        if (flags.makesVideo())
            throw CLI::ValidationError(
                "--output: is a video, which can't be made in parts; write name.####.png, and make the video "
                "of them with farm collect --video");
        const project::Project project = flags.load();
        const project::AnimationOutput output = flags.output(project);
        flags.checkFiles(project, output);
        Job job = jobFor(project, output);
        job.threads = session.flags.threads;
        const Engine& chosen = engine(engineKey);
        if (isDry) return session.finish(json(job), dryText(job, chosen));
        refuseRunning(job);
        writeJob(job);
        chosen.submit(job, terms, session.task("farm"), [&](const std::string& number) {
            job.number = number;
            writeNumber(job);
        });
        session.finish(json(job), text(job, project));
    }

    Job jobFor(const project::Project& project, const project::AnimationOutput& output) const {
        Job job;
        job.folder = fs::absolute(folder.empty() ? jobFolder(output.path) : folder).lexically_normal();
        job.engine = engineKey;
        job.program = fs::read_symlink("/proc/self/exe");
        job.workplace = fs::current_path();
        job.pattern = fs::absolute(output.path).lexically_normal();
        job.arguments = arguments();
        job.tries = tries;
        job.rate = output.rate;
        if (needsFrameBefore(project))
            job.chunks = {output.range};
        else
            job.chunks = chunksOf(output.range, chunk, hasKeyframes(project) ? project.coherence.every : 1);
        return job;
    }

    static bool hasKeyframes(const project::Project& project) {
        return project.method == "image-based" && project.coherence.hasKeyframes();
    }
    /// Whether each frame builds on the one before, so that a chunk would make all before it too.
    static bool needsFrameBefore(const project::Project& project) {
        return project.method == "image-based" && !project.coherence.hasKeyframes() &&
               project.coherence.mode != methods::Coherence::Independent;
    }

    /// The flags as they were written.
    std::vector<std::string> arguments() const {
        std::vector<std::string> words;
        for (const CLI::Option* option : passedOn)
            for (const std::string& value : option->results())
                words.push_back(option->get_positional() ? value : option->get_name() + "=" + value);
        return words;
    }

    static void refuseRunning(const Job& job) {
        std::error_code ignored;
        if (!fs::exists(job.folder / "job.json", ignored)) return;
        const Job earlier = readJob(job.folder);
        if (!earlier.number.empty() && !engine(earlier.engine).queue(earlier).empty())
            throw Error(job.folder.string(), fmt::format("is of job {}, which goes on", earlier.number),
                        "wait for it, cancel it, or name another folder with --job");
    }

    std::string dryText(const Job& job, const Engine& chosen) const {
        return fmt::format("{}\n# {}\n{}", chosen.plan(job, terms), job.script().string(), chunkScript(job));
    }

    nlohmann::json json(const Job& job) const {
        nlohmann::json json{{"job", job.number},
                            {"folder", job.folder.string()},
                            {"engine", job.engine},
                            {"frames", job.range().count()},
                            {"chunks", nlohmann::json::array()}};
        for (int i = 1; i <= int(job.chunks.size()); ++i) {
            const exporting::FrameRange frames = job.chunks[std::size_t(i) - 1];
            json["chunks"].push_back({{"frames", fmt::format("{}-{}", frames.first, frames.last)},
                                      {"command", commandLine(job, i)}});
        }
        return json;
    }

    std::string text(const Job& job, const project::Project& project) const {
        std::string text =
            fmt::format("job {} on {}: {} frames in {} {}", job.number, job.engine, job.range().count(),
                        job.chunks.size(), job.chunks.size() == 1 ? "chunk" : "chunks");
        if (needsFrameBefore(project))
            text += ", since every frame builds on the one before";
        else if (hasKeyframes(project))
            text += fmt::format(", each from a keyframe on (every {} frames)", project.coherence.every);
        return text + fmt::format("\nchiaro farm status {}", quoted(job.folder.string()));
    }
};

/// What belongs to this command or differs from chunk to chunk.
bool isOwn(const std::string& name) {
    static const std::vector<std::string> own{"--help", "--frames", "--resume", "--overwrite"};
    return std::ranges::find(own, name) != own.end();
}

void addEngineFlags(CLI::App& command, SubmitCommand& state) {
    std::vector<std::string> keys;
    std::string what;
    for (const Engine& engine : engines()) {
        keys.push_back(engine.key);
        what += (what.empty() ? "" : "; ") + engine.key + ": " + engine.what;
    }
    command
        .add_option("--engine", state.engineKey, fmt::format("Who runs the chunks. {} (default slurm)", what))
        ->check(CLI::IsMember(keys));
    command
        .add_option("--chunk", state.chunk,
                    "Frames in a chunk (1..100000; default 24); made more where that lets each begin at a "
                    "keyframe")
        ->check(CLI::Range(1, 100000));
    command.add_option("--tries", state.tries, "How often a chunk may be begun (1..100; default 3)")
        ->check(CLI::Range(1, 100));
    command
        .add_option("--at-most", state.terms.atMost,
                    "Chunks that run at a time (1..10000; default: as many as Slurm likes, one with local)")
        ->check(CLI::Range(1, 10000));
    command.add_option("--engine-option", state.terms.options,
                       "A line for #SBATCH, as --engine-option=--partition=long; may be repeated");
    command.add_option("--job", state.folder,
                       "Folder for the job's script, state and logs (default: name.farm beside the frames)");
    command.add_flag("--dry-run", state.isDry, "Print what would be submitted and write nothing");
}

}  // namespace

void addSubmitCommand(CLI::App& farm, Session& session) {
    CLI::App* command = farm.add_subcommand(
        "submit", "Give the frames of an animation to a farm, in chunks; takes what animate takes");
    auto state = std::make_shared<SubmitCommand>();
    state->flags.addTo(*command);
    for (CLI::Option* option : command->get_options())
        if (!isOwn(option->get_name())) state->passedOn.push_back(option);
    addEngineFlags(*command, *state);
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli::farm
