#include "tests/cli/program.h"

#include "core/base/atomic_file.h"
#include "tests/support/support.h"

#include <sys/wait.h>

#include <csignal>
#include <unistd.h>

namespace chiaro::test {

struct RunningChiaro::Files {
    TemporaryFolder folder;
    std::string out = (folder / "out").string();
    std::string error = (folder / "error").string();
};

RunningChiaro::RunningChiaro(const std::vector<std::string>& arguments) : m_files(new Files) {
    std::vector<char*> argv{const_cast<char*>(CHIARO_PROGRAM)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    m_process = fork();
    if (m_process != 0) return;
    setenv("XDG_CACHE_HOME", (m_files->folder / "cache").c_str(), 1);  // not the user's own
    if (!freopen(m_files->out.c_str(), "w", stdout) || !freopen(m_files->error.c_str(), "w", stderr))
        _exit(126);
    execv(CHIARO_PROGRAM, argv.data());
    _exit(127);
}

RunningChiaro::~RunningChiaro() {
    if (m_process < 0) return;
    signal(SIGKILL);
    waitpid(m_process, nullptr, 0);
}

void RunningChiaro::signal(int number) const {
    kill(m_process, number);
}

Outcome RunningChiaro::wait() {
    int state = 0;
    waitpid(m_process, &state, 0);
    m_process = -1;
    return {WIFEXITED(state) ? WEXITSTATUS(state) : -1, readFile(m_files->out, 1 << 26),
            readFile(m_files->error, 1 << 26)};
}

Outcome chiaro(const std::vector<std::string>& arguments) {
    return RunningChiaro(arguments).wait();
}

Outcome interruptedChiaro(const std::vector<std::string>& arguments, int milliseconds) {
    RunningChiaro run(arguments);
    usleep(useconds_t(milliseconds) * 1000);
    run.signal(SIGINT);
    return run.wait();
}

}  // namespace chiaro::test
