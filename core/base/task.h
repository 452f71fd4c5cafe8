#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>

namespace chiaro {

/// Thrown by Task::checkpoint when the work was cancelled; never an error to show.
class Cancelled {};

/// How long work tells its progress and hears that it was cancelled. Safe to use from several threads.
/// A default Task is never cancelled and reports to nobody.
class Task {
public:
    /// Called with the fraction done in [0, 1], which never falls; from any thread, but one call at a time.
    using Progress = std::function<void(double fraction)>;

    Task() = default;
    explicit Task(std::stop_token stop, Progress progress = {});

    bool cancelled() const { return m_stop.stop_requested(); }
    /// Throws Cancelled once cancellation was asked for. Call it at least every few milliseconds of work.
    void checkpoint() const;
    /// Tells the fraction of this task that is done, in [0, 1].
    void report(double fraction) const;

    /// A task whose progress 0..1 fills this one's progress from `begin` to `end`.
    Task part(double begin, double end) const;

    /// Counts equal steps done by several threads: report() after each, checkpoint() before.
    class Steps {
    public:
        Steps(const Task& task, std::size_t count) : m_task(task), m_count(count) {}
        void done();

    private:
        const Task& m_task;
        std::size_t m_count;
        std::atomic<std::size_t> m_done{0};
    };

private:
    struct Reporter {
        std::mutex mutex;
        double highest = 0;
        Progress progress;
    };

    std::stop_token m_stop;
    std::shared_ptr<Reporter> m_reporter;
    double m_begin = 0;
    double m_end = 1;
};

}  // namespace chiaro
