#include "tests/cli/program.h"

#include "core/base/atomic_file.h"
#include "tests/support/support.h"

#include <sys/wait.h>

#include <csignal>
#include <unistd.h>

namespace chiaro::test {

namespace {

Outcome runProgram(const std::vector<std::string>& arguments, int interruptAfter) {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    const std::string error = (folder / "error").string();
    std::vector<char*> argv{const_cast<char*>(CHIARO_PROGRAM)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);  // not the user's own
        if (!freopen(out.c_str(), "w", stdout) || !freopen(error.c_str(), "w", stderr)) _exit(126);
        execv(CHIARO_PROGRAM, argv.data());
        _exit(127);
    }
    if (interruptAfter > 0) {
        usleep(useconds_t(interruptAfter) * 1000);
        kill(child, SIGINT);
    }
    int state = 0;
    waitpid(child, &state, 0);
    return {WIFEXITED(state) ? WEXITSTATUS(state) : -1, readFile(out, 1 << 26), readFile(error, 1 << 26)};
}

}  // namespace

Outcome chiaro(const std::vector<std::string>& arguments) {
    return runProgram(arguments, 0);
}

Outcome interruptedChiaro(const std::vector<std::string>& arguments, int milliseconds) {
    return runProgram(arguments, milliseconds);
}

}  // namespace chiaro::test
