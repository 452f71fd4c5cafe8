#pragma once

#include "core/base/task.h"

#include <sys/types.h>

#include <string>
#include <vector>

namespace chiaro::cli {

/// How a program ended and what it said.
struct Ended {
    int status = -1;  ///< exit status, 128 + the signal that ended it, or 127 when it couldn't be started
    std::string out;
    std::string error;
};

/// Runs a program from the path and waits for it; once the task is cancelled it is asked to end. Throws
/// Error, Cancelled.
Ended runProgram(const std::vector<std::string>& words, const Task& task = {});

/// Starts a program in a process group of its own, with no signal held back. Throws Error.
pid_t startProgram(const std::vector<std::string>& words);
/// Exit status, or 128 + the signal, of what waitpid() told.
int exitStatus(int state);

}  // namespace chiaro::cli
