#pragma once

#include "app/jobs/job_runner.h"

#include <QAbstractTableModel>
#include <QTimer>

#include <deque>

namespace chiaro::app {

/// The jobs that run, oldest first, and below them those that ended, latest first. What was superseded is not
/// listed: something newer took its place; nor what was too short to read about.
class JobModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Title, State, Time, ColumnCount };
    /// Of the State column: progress in [0, 1] of what runs, invalid of what ended.
    static constexpr int ProgressRole = Qt::UserRole;

    explicit JobModel(JobRunner& jobs, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

    bool isRunning(int row) const { return row >= 0 && row < int(m_running.size()); }
    int runningCount() const { return int(m_running.size()); }
    /// Cancels what runs in the row.
    void cancel(int row);
    void clearEnded();

private:
    void follow();
    void refresh();
    void keep(const JobRunner::Ending& ending);
    QVariant runningText(const JobRunner::JobInfo& job, int column) const;
    QVariant endedText(const JobRunner::Ending& ending, int column) const;

    JobRunner& m_jobs;
    std::vector<JobRunner::JobInfo> m_running;
    std::deque<JobRunner::Ending> m_ended;
    QTimer m_seconds;  ///< time passes though a job may say nothing
};

}  // namespace chiaro::app
