#include "app/cli/child_process.h"
#include "app/cli/farm/engine.h"
#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>
#include <sys/wait.h>

#include <csignal>
#include <deque>
#include <thread>
#include <unistd.h>

namespace chiaro::cli::farm {

namespace {

std::string plan(const Job& job, const Terms&) {
    std::string lines;
    for (int chunk = 1; chunk <= int(job.chunks.size()); ++chunk) lines += commandLine(job, chunk) + "\n";
    return lines;
}

/// The chunks of a job as processes of this machine, some at a time.
class LocalRun {
public:
    LocalRun(const Job& job, int atMost, const Task& task) : m_job(job), m_atMost(atMost), m_task(task) {
        for (int chunk = 1; chunk <= int(job.chunks.size()); ++chunk) m_waiting.push_back({chunk, 1});
    }
    ~LocalRun() {
        for (const auto& [process, chunk] : m_running) ::kill(-process, SIGTERM);
        for (const auto& [process, chunk] : m_running) ::waitpid(process, nullptr, 0);
    }
    LocalRun(const LocalRun&) = delete;
    LocalRun& operator=(const LocalRun&) = delete;

    void run() {
        while (!m_waiting.empty() || !m_running.empty()) {
            while (!m_waiting.empty() && int(m_running.size()) < m_atMost) start();
            for (auto one = m_running.begin(); one != m_running.end();) {
                int state = 0;
                const bool isOver = ::waitpid(one->first, &state, WNOHANG) == one->first;
                if (isOver) finish(one->second, exitStatus(state));
                one = isOver ? m_running.erase(one) : std::next(one);
            }
            m_task.checkpoint();
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        if (!m_failed.empty())
            throw Error(m_job.folder.string(), fmt::format("chunk {} failed", fmt::join(m_failed, ", ")),
                        "read " + m_job.log(m_failed.front()).string() + " and submit again with --resume");
    }

private:
    struct Try {
        int chunk;
        int number;
    };

    void start() {
        const Try next = m_waiting.front();
        m_waiting.pop_front();
        m_running[startProgram({"bash", m_job.script().string(), std::to_string(next.chunk),
                                std::to_string(next.number)})] = next;
    }

    void finish(Try ended, int status) {
        if (status != 0 && status != 2 && status != 130 && ended.number < m_job.tries)
            return m_waiting.push_back({ended.chunk, ended.number + 1});
        if (status != 0) m_failed.push_back(ended.chunk);
        m_task.report(double(++m_finished) / double(m_job.chunks.size()));
    }

    const Job& m_job;
    int m_atMost;
    const Task& m_task;
    std::deque<Try> m_waiting;
    std::map<pid_t, Try> m_running;
    std::vector<int> m_failed;
    std::size_t m_finished = 0;
};

void submit(const Job& job, const Terms& terms, const Task& task,
            const std::function<void(const std::string&)>& accepted) {
    accepted(std::to_string(::getpid()));
    LocalRun(job, std::max(1, terms.atMost), task).run();
}

/// Chunks of a run that goes on: those that aren't over.
std::map<int, Queued> queue(const Job& job) {
    std::map<int, Queued> chunks;
    if (job.number.empty() || ::kill(std::atoi(job.number.c_str()), 0) != 0) return chunks;
    for (int chunk = 1; chunk <= int(job.chunks.size()); ++chunk) {
        const std::optional<Note> note = noteOf(job, chunk);
        if (!note)
            chunks[chunk] = Queued::Waiting;
        else if (note->kind == Note::Kind::Running)
            chunks[chunk] = Queued::Running;
        else if (note->kind == Note::Kind::Failed && note->tries < job.tries)
            chunks[chunk] = Queued::Waiting;
    }
    return chunks;
}

}  // namespace

Engine localEngine() {
    return {"local", "processes on this machine; returns when all are done",    plan, submit,
            queue,   [](const std::string&) { return std::filesystem::path(); }};
}

}  // namespace chiaro::cli::farm
