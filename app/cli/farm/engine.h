#pragma once

#include "app/cli/farm/job.h"
#include "core/base/task.h"

#include <functional>
#include <map>
#include <span>

namespace chiaro::cli::farm {

/// How a job is given to an engine.
struct Terms {
    int atMost = 0;                    ///< chunks at a time; 0: as the engine likes
    std::vector<std::string> options;  ///< handed on to it as they are
};

/// Whether a chunk is still the engine's business.
enum class Queued { Waiting, Running };

/// What runs the chunks of a job: a row of the table that --engine chooses from, each in a file of its own.
struct Engine {
    std::string key;
    std::string what;  ///< for --help
    /// What it is given, for --dry-run.
    std::string (*plan)(const Job& job, const Terms& terms);
    /// Gives it the job, whose folder is written. Calls `accepted` with the number that it has from then on;
    /// an engine that works here returns once all is done. Throws Error, Cancelled.
    void (*submit)(const Job& job, const Terms& terms, const Task& task,
                   const std::function<void(const std::string& number)>& accepted);
    /// The chunks that wait or run, by number. Throws Error.
    std::map<int, Queued> (*queue)(const Job& job);
    /// The folder of a job of this number; empty when it knows none.
    std::filesystem::path (*find)(const std::string& number);
};

std::span<const Engine> engines();
/// Throws Error naming those that there are.
const Engine& engine(const std::string& key);

Engine slurmEngine();
Engine localEngine();

}  // namespace chiaro::cli::farm
