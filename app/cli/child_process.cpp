#include "app/cli/child_process.h"

#include "core/base/error.h"

#include <sys/wait.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <thread>
#include <unistd.h>

namespace chiaro::cli {

namespace {

/// A file without a name that a program may write to.
class Scratch {
public:
    Scratch() : m_file(std::tmpfile()) {
        if (!m_file)
            throw Error(std::filesystem::temp_directory_path().string(), "holds no file",
                        "free some space there");
    }
    ~Scratch() { std::fclose(m_file); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    int number() const { return ::fileno(m_file); }
    std::string text() const {
        std::string text;
        std::rewind(m_file);
        char buffer[4096];
        for (std::size_t read; (read = std::fread(buffer, 1, sizeof buffer, m_file)) > 0;)
            text.append(buffer, read);
        return text;
    }

private:
    std::FILE* m_file;
};

pid_t spawn(const std::vector<std::string>& words, const posix_spawn_file_actions_t* actions) {
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    pid_t child = -1;
    const int problem = ::posix_spawnp(&child, argv[0], actions, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    if (problem != 0)
        throw Error(words.front(), std::string("could not be started (") + std::strerror(problem) + ")",
                    "install it, or choose another --engine");
    return child;
}

}  // namespace

Ended runProgram(const std::vector<std::string>& words, const Task& task) {
    const Scratch out, error;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, out.number(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, error.number(), STDERR_FILENO);
    const pid_t child = spawn(words, &actions);
    posix_spawn_file_actions_destroy(&actions);
    int state = 0;
    while (::waitpid(child, &state, WNOHANG) == 0) {
        if (task.cancelled()) {
            ::kill(-child, SIGTERM);
            ::waitpid(child, &state, 0);
            task.checkpoint();
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return {exitStatus(state), out.text(), error.text()};
}

pid_t startProgram(const std::vector<std::string>& words) {
    return spawn(words, nullptr);
}

int exitStatus(int state) {
    return WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
}

}  // namespace chiaro::cli
