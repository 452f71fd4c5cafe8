#include "app/jobs/job_runner.h"

#include "core/base/error.h"
#include "core/base/import.h"
#include "core/base/memory_reserve.h"

#include <QtWidgets>

#include <algorithm>
#include <stop_token>

namespace chiaro::app {

struct JobRunner::Job {
    JobSpec spec;
    std::stop_source stop;
    std::atomic<double> progress{0};
    QElapsedTimer clock;

    double seconds() const { return double(clock.elapsed()) / 1000; }
};

JobRunner::JobRunner(QObject* parent) : QObject(parent) {
    // Core spreads one job over all processors; a few threads keep short jobs from waiting behind long ones.
    m_pool.setMaxThreadCount(std::max(4, QThread::idealThreadCount()));
    m_progressTimer.setInterval(50);
    connect(&m_progressTimer, &QTimer::timeout, this, &JobRunner::progressed);
}

JobRunner::~JobRunner() {
    for (const auto& [number, job] : m_jobs) job->stop.request_stop();
    m_pool.waitForDone();
}

int JobRunner::launch(JobSpec spec, Work work) {
    if (!spec.slot.isEmpty()) drop(spec.slot);
    const int number = ++m_last;
    auto job = std::make_shared<Job>();
    job->spec = std::move(spec);
    job->clock.start();
    m_jobs.emplace(number, job);
    m_pool.start([this, number, job, work = std::move(work)] {
        std::function<void()> done;
        QString error;
        try {
            const Task task(job->stop.get_token(), [job](double fraction) { job->progress = fraction; });
            task.checkpoint();
            const ImportsOfTask imports(task);
            done = work(task);
        } catch (const Cancelled&) {
        } catch (const std::bad_alloc&) {
            error = tr("%1: there is not enough memory; choose a smaller size").arg(job->spec.title);
        } catch (const std::exception& problem) {
            error = QString::fromStdString(problem.what());
        }
        QMetaObject::invokeMethod(
            this, [this, number, done, error] { finish(number, done, error); }, Qt::QueuedConnection);
    });
    m_progressTimer.start();
    Q_EMIT jobsChanged();
    return number;
}

void JobRunner::finish(int number, const std::function<void()>& done, const QString& error) {
    const auto found = m_jobs.find(number);
    if (found == m_jobs.end()) return;  // cancelled or superseded meanwhile
    const std::shared_ptr<Job> job = found->second;
    m_jobs.erase(found);
    keepMemoryReserve();  // it may have been used up
    tellEnd(number, *job, error.isEmpty() ? Ending::Kind::Done : Ending::Kind::Failed, error);
    if (!error.isEmpty()) {
        if (job->spec.failed)
            job->spec.failed(error);
        else
            Q_EMIT failed(error);
    } else if (done) {
        done();
    }
    ended();
}

void JobRunner::tellEnd(int number, const Job& job, Ending::Kind kind, const QString& reason) {
    if (job.spec.isQuiet) return;
    Q_EMIT jobEnded({number, job.spec.title, kind, reason, job.seconds()});
}

void JobRunner::ended() {
    Q_EMIT jobsChanged();
    if (!isIdle()) return;
    m_progressTimer.stop();
    Q_EMIT idle();
}

std::vector<JobRunner::JobInfo> JobRunner::jobs() const {
    std::vector<JobInfo> list;
    for (const auto& [number, job] : m_jobs)
        if (!job->spec.isQuiet) list.push_back({number, job->spec.title, job->progress, job->seconds()});
    return list;
}

bool JobRunner::isRunning(const QString& slot) const {
    return std::any_of(m_jobs.begin(), m_jobs.end(),
                       [&](const auto& job) { return job.second->spec.slot == slot; });
}

bool JobRunner::drop(const QString& slot) {
    std::vector<std::pair<int, std::shared_ptr<Job>>> dropped;
    for (const auto& [number, job] : m_jobs)
        if (job->spec.slot == slot) dropped.emplace_back(number, job);
    for (const auto& [number, job] : dropped) {
        m_jobs.erase(number);
        job->stop.request_stop();
        tellEnd(number, *job, Ending::Kind::Superseded);
    }
    return !dropped.empty();
}

void JobRunner::supersede(const QString& slot) {
    if (drop(slot)) ended();
}

void JobRunner::cancel(int number) {
    const auto found = m_jobs.find(number);
    if (found == m_jobs.end()) return;
    const std::shared_ptr<Job> job = found->second;
    m_jobs.erase(found);
    job->stop.request_stop();
    tellEnd(number, *job, Ending::Kind::Cancelled);
    if (job->spec.cancelled) job->spec.cancelled();
    ended();
}

void JobRunner::cancelAll() {
    for (const JobInfo& job : jobs()) cancel(job.number);
}

}  // namespace chiaro::app
