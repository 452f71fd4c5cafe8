#include "app/job_model.h"

#include "widgets/icon_engine.h"

#include <QtWidgets>

#include <algorithm>

namespace chiaro::app {

namespace {

constexpr std::size_t keptEndings = 100;
constexpr double readableSeconds = 0.3;

QString duration(double seconds) {
    if (seconds < 9.95) return QObject::tr("%1 s").arg(seconds, 0, 'f', 1);
    const int whole = int(std::lround(seconds));
    if (whole < 60) return QObject::tr("%1 s").arg(whole);
    return QObject::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
}

}  // namespace

JobModel::JobModel(JobRunner& jobs, QObject* parent) : QAbstractTableModel(parent), m_jobs(jobs) {
    connect(&jobs, &JobRunner::jobEnded, this, &JobModel::keep);
    connect(&jobs, &JobRunner::jobsChanged, this, &JobModel::follow);
    connect(&jobs, &JobRunner::progressed, this, &JobModel::refresh);
    m_seconds.setInterval(500);
    connect(&m_seconds, &QTimer::timeout, this, &JobModel::refresh);
    follow();
}

int JobModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(m_running.size() + m_ended.size());
}

int JobModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant JobModel::runningText(const JobRunner::JobInfo& job, int column) const {
    if (column == Title) return job.title;
    if (column == State) return tr("%1 %").arg(int(job.progress * 100));
    // Early guesses are wild.
    if (job.progress < 0.03 || job.seconds < 1) return duration(job.seconds);
    return tr("%1 left").arg(duration(job.seconds * (1 - job.progress) / job.progress));
}

QVariant JobModel::endedText(const JobRunner::Ending& ending, int column) const {
    using Kind = JobRunner::Ending::Kind;
    if (column == Title) return ending.title;
    if (column == Time) return duration(ending.seconds);
    if (ending.kind == Kind::Failed) return ending.reason;
    return ending.kind == Kind::Cancelled ? tr("cancelled") : tr("done");
}

QVariant JobModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const auto row = std::size_t(index.row());
    const bool runs = row < m_running.size();
    const JobRunner::Ending* ending = runs ? nullptr : &m_ended[row - m_running.size()];
    const bool failed = ending && ending->kind == JobRunner::Ending::Kind::Failed;
    switch (role) {
        case Qt::DisplayRole:
            return runs ? runningText(m_running[row], index.column()) : endedText(*ending, index.column());
        case Qt::ToolTipRole:
            if (runs) return tr("%1\nDelete cancels it").arg(m_running[row].title);
            return failed ? ending->title + "\n" + ending->reason : ending->title;
        case Qt::ForegroundRole:
            if (runs) return {};
            if (failed && index.column() == State) return QBrush(widgets::iconColors().error);
            return QApplication::palette().brush(QPalette::PlaceholderText);
        case Qt::TextAlignmentRole:
            return int(Qt::AlignVCenter | (index.column() == Time ? Qt::AlignRight : Qt::AlignLeft));
        case ProgressRole:
            return runs && index.column() == State ? QVariant(m_running[row].progress) : QVariant();
        default:
            return {};
    }
}

void JobModel::cancel(int row) {
    if (isRunning(row)) m_jobs.cancel(m_running[std::size_t(row)].number);
}

void JobModel::clearEnded() {
    beginResetModel();
    m_ended.clear();
    endResetModel();
}

void JobModel::keep(const JobRunner::Ending& ending) {
    using Kind = JobRunner::Ending::Kind;
    const bool isWorthReading = ending.kind == Kind::Failed || ending.kind == Kind::Cancelled ||
                                (ending.kind == Kind::Done && ending.seconds >= readableSeconds);
    if (!isWorthReading) return;
    beginResetModel();
    m_ended.push_front(ending);
    if (m_ended.size() > keptEndings) m_ended.pop_back();
    m_running = m_jobs.jobs();
    endResetModel();
}

void JobModel::follow() {
    const auto now = m_jobs.jobs();
    const bool isSame =
        std::ranges::equal(now, m_running, {}, &JobRunner::JobInfo::number, &JobRunner::JobInfo::number);
    if (!isSame) beginResetModel();
    m_running = now;
    if (!isSame) endResetModel();
    if (m_running.empty())
        m_seconds.stop();
    else
        m_seconds.start();
}

void JobModel::refresh() {
    follow();
    if (!m_running.empty())
        Q_EMIT dataChanged(index(0, State), index(int(m_running.size()) - 1, Time),
                           {Qt::DisplayRole, ProgressRole});
}

}  // namespace chiaro::app
