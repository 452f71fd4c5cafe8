#include "app/cli/child_process.h"
#include "app/cli/farm/engine.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>

#include <sstream>

namespace chiaro::cli::farm {

namespace {

namespace fs = std::filesystem;

/// A name in which Slurm puts nothing for %.
std::string withoutPatterns(const fs::path& path) {
    std::string result;
    for (const char letter : path.string()) result += letter == '%' ? "%%" : std::string(1, letter);
    return result;
}

std::string plan(const Job& job, const Terms& terms) {
    std::string options;
    const auto add = [&options](const std::string& option) { options += "#SBATCH " + option + "\n"; };
    add("--job-name=" + quoted("chiaro-" + job.folder.stem().string()));
    add(fmt::format("--array=1-{}{}", job.chunks.size(),
                    terms.atMost > 0 ? fmt::format("%{}", terms.atMost) : ""));
    add("--requeue");
    add("--open-mode=append");
    add(fmt::format("--chdir=\"{}\"", job.folder.string()));
    add(fmt::format("--output=\"{}/logs/slurm-%a.log\"", withoutPatterns(job.folder)));
    if (job.threads > 0) add(fmt::format("--cpus-per-task={}", job.threads));
    for (const std::string& option : terms.options) add(option);
    return fmt::format(R"(#!/bin/bash
{options}
try=$(( ${{SLURM_RESTART_COUNT:-0}} + 1 ))
bash {script} "$SLURM_ARRAY_TASK_ID" "$try"
status=$?
# Wrong usage fails every time, and what was interrupted is not wanted.
if [ $status -ne 0 ] && [ $status -ne 2 ] && [ $status -ne 130 ] && [ $try -lt {tries} ]; then
    scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID" && sleep 30
fi
exit $status
)",
                       fmt::arg("options", options), fmt::arg("script", quoted(job.script().string())),
                       fmt::arg("tries", job.tries));
}

void submit(const Job& job, const Terms& terms, const Task&,
            const std::function<void(const std::string&)>& accepted) {
    const fs::path script = job.folder / "slurm.sh";
    writeFileAtomically(script, plan(job, terms));
    const Ended sbatch = runProgram({"sbatch", "--parsable", script.string()});
    // NUMBER or NUMBER;CLUSTER
    const std::string number = sbatch.out.substr(0, sbatch.out.find_first_of(";\n"));
    if (sbatch.status != 0 || number.empty())
        throw Error("sbatch", "refused the job (" + sbatch.error.substr(0, 300) + ")",
                    "see whether Slurm runs here, or choose --engine local");
    accepted(number);
}

std::map<int, Queued> queue(const Job& job) {
    const Ended squeue =
        runProgram({"squeue", "--noheader", "--array", "--jobs=" + job.number, "--format=%K %T"});
    std::map<int, Queued> chunks;
    if (squeue.status != 0) {
        // Slurm forgets jobs some minutes after their end.
        if (squeue.error.find("Invalid job id") != std::string::npos) return chunks;
        throw Error("squeue", "gave no answer (" + squeue.error.substr(0, 300) + ")",
                    "see whether Slurm runs here");
    }
    std::istringstream lines(squeue.out);
    int chunk = 0;
    for (std::string state; lines >> chunk >> state;)
        chunks[chunk] = state == "PENDING" || state == "REQUEUED" || state == "REQUEUE_HOLD"
                            ? Queued::Waiting
                            : Queued::Running;
    return chunks;
}

fs::path find(const std::string& number) {
    try {
        const Ended shown = runProgram({"scontrol", "--oneliner", "show", "job", number});
        const std::size_t begin = shown.out.find(" WorkDir=");
        if (shown.status != 0 || begin == std::string::npos) return {};
        const std::size_t value = begin + 9;
        return shown.out.substr(value, shown.out.find(" StdErr=", value) - value);
    } catch (const Error&) {
        return {};  // no Slurm here
    }
}

}  // namespace

Engine slurmEngine() {
    return {"slurm", "an array job of Slurm, a task a chunk; chunks that fail are requeued",
            plan,    submit,
            queue,   find};
}

}  // namespace chiaro::cli::farm
