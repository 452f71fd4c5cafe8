#pragma once

namespace chiaro::cli {

/// Runs one command. Returns the exit status: 0 done, 1 the input can't be used or the work failed, 2 wrong
/// usage, 130 interrupted. Errors are one line on stderr.
int run(int argc, const char* const* argv);

}  // namespace chiaro::cli
