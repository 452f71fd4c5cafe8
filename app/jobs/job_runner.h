#pragma once

#include "core/base/task.h"

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>

#include <functional>
#include <map>
#include <memory>
#include <type_traits>
#include <vector>

namespace chiaro::app {

/// What a job is and what happens when it gives no result. The functions are called on the GUI thread.
struct JobSpec {
    QString title;  ///< "Synthesising oil"
    QString slot;   ///< starting a job stops the one of the same slot and drops its result; empty: its own
    std::function<void(const QString& message)> failed;  ///< without one the runner's failed() tells it
    std::function<void()> cancelled;                     ///< by the artist; never when it was superseded
    bool isQuiet = false;  ///< short, and too frequent to be told of or cancelled: jobs() leaves it out
};

/// Runs work longer than a frame off the GUI thread.
///
/// Work takes immutable snapshots and a Task, and returns a value; `done` gets the value on the GUI thread,
/// unless the job was cancelled or superseded meanwhile: then nothing of it is seen again. Errors arrive as
/// sentences. All of this is to be called from the GUI thread.
class JobRunner : public QObject {
    Q_OBJECT

public:
    explicit JobRunner(QObject* parent = nullptr);
    /// Stops all jobs and waits for their threads.
    ~JobRunner() override;

    /// Returns the job's number; numbers rise in the order of starting.
    template <class Work, class Done>
    int start(JobSpec spec, Work work, Done done) {
        using Result = std::invoke_result_t<Work, const Task&>;
        return launch(std::move(spec), [work = std::move(work), done = std::move(done)](const Task& task) {
            auto result = std::make_shared<Result>(work(task));
            return std::function<void()>([result, done] { done(std::move(*result)); });
        });
    }

    struct JobInfo {
        int number = 0;
        QString title;
        double progress = 0;  ///< in [0, 1]
        double seconds = 0;   ///< since it was started
    };
    std::vector<JobInfo> jobs() const;
    /// How a job ended.
    struct Ending {
        enum class Kind { Done, Failed, Cancelled, Superseded };
        int number = 0;
        QString title;
        Kind kind = Kind::Done;
        QString reason;  ///< why it failed
        double seconds = 0;
    };
    bool isIdle() const { return m_jobs.empty(); }
    /// Threads that are at work, those included whose job was cancelled and that have yet to notice.
    int threadsAtWork() const { return m_pool.activeThreadCount(); }
    bool isRunning(const QString& slot) const;

    /// Drops whatever runs in a slot, silently.
    void supersede(const QString& slot);

public Q_SLOTS:
    void cancel(int number);
    void cancelAll();

Q_SIGNALS:
    void jobsChanged();
    /// Before jobsChanged().
    void jobEnded(const chiaro::app::JobRunner::Ending& ending);
    void progressed();  ///< some job's progress, at most every 50 ms
    void failed(const QString& message);
    void idle();  ///< the last job ended and started no other

private:
    struct Job;
    /// Runs on a thread and returns what to do on the GUI thread.
    using Work = std::function<std::function<void()>(const Task& task)>;

    int launch(JobSpec spec, Work work);
    /// False when nothing runs in the slot.
    bool drop(const QString& slot);
    void finish(int number, const std::function<void()>& done, const QString& error);
    void ended();
    void tellEnd(int number, const Job& job, Ending::Kind kind, const QString& reason = {});

    QThreadPool m_pool;
    QTimer m_progressTimer;
    std::map<int, std::shared_ptr<Job>> m_jobs;
    int m_last = 0;
};

}  // namespace chiaro::app
