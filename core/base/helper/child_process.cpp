#include "core/base/helper/child_process.h"

#include <sys/wait.h>

#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <spawn.h>
#include <system_error>
#include <thread>

namespace chiaro::helper {

struct ChildProcess::State {
    pid_t id = -1;
    std::mutex mutex;
    std::condition_variable changed;
    bool ended = false;  ///< and waited for: the id may be another's by now
    int status = 0;
};

namespace {

void check(int error, const char* what) {
    if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// posix_spawn's two objects, destroyed whatever happens.
struct SpawnPlan {
    posix_spawn_file_actions_t files{};
    posix_spawnattr_t attributes{};
    SpawnPlan() {
        check(::posix_spawn_file_actions_init(&files), "file actions");
        check(::posix_spawnattr_init(&attributes), "attributes");
    }
    ~SpawnPlan() {
        ::posix_spawn_file_actions_destroy(&files);
        ::posix_spawnattr_destroy(&attributes);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;
};

/// No signal handler or mask of ours, and a group of its own, so that Ctrl+C in a terminal ends us alone.
void setSignals(SpawnPlan& plan) {
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    check(::posix_spawnattr_setsigmask(&plan.attributes, &none), "signal mask");
    check(::posix_spawnattr_setsigdefault(&plan.attributes, &all), "signals");
    check(::posix_spawnattr_setpgroup(&plan.attributes, 0), "process group");
    check(::posix_spawnattr_setflags(&plan.attributes,
                                     POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP),
          "flags");
}

void setFiles(SpawnPlan& plan, const FileHandle& socket) {
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        check(::posix_spawn_file_actions_addopen(&plan.files, standard, "/dev/null",
                                                 standard == STDIN_FILENO ? O_RDONLY : O_WRONLY, 0),
              "standard files");
    // A handle that already has the number it is to get would keep closing itself on exec.
    const int dup = ChildProcess::socketHandle;
    check(::posix_spawn_file_actions_adddup2(&plan.files, socket.get(), dup), "socket");
    check(::posix_spawn_file_actions_addclosefrom_np(&plan.files, dup + 1), "other files");
}

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           const FileHandle& socket)
    : m_state(std::make_shared<State>()) {
    SpawnPlan plan;
    setFiles(plan, socket);
    setSignals(plan);
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    check(::posix_spawn(&m_state->id, program.c_str(), &plan.files, &plan.attributes, argv.data(), environ),
          "start");
    std::thread([state = m_state] {
        siginfo_t info{};
        while (::waitid(P_PID, id_t(state->id), &info, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
        }
        const std::lock_guard lock(state->mutex);
        ::waitpid(state->id, &state->status, 0);
        state->ended = true;
        state->changed.notify_all();
    }).detach();
}

ChildProcess::~ChildProcess() {
    kill();
}

int ChildProcess::id() const {
    return m_state->id;
}

void ChildProcess::kill() {
    const std::lock_guard lock(m_state->mutex);
    if (!m_state->ended) ::kill(m_state->id, SIGKILL);
}

std::string ChildProcess::howItEnded() const {
    std::unique_lock lock(m_state->mutex);
    if (!m_state->changed.wait_for(lock, std::chrono::seconds(1), [&] { return m_state->ended; }))
        return "stopped answering";
    const int status = m_state->status;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) return "was killed by the system";
    if (WIFSIGNALED(status)) return std::string("crashed (") + ::strsignal(WTERMSIG(status)) + ")";
    return "ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace chiaro::helper
