#include "app/job_status.h"

#include "app/jobs/job_runner.h"
#include "widgets/tool_button.h"

#include <QtWidgets>

namespace chiaro::app {

JobStatus::JobStatus(JobRunner& jobs, QWidget* parent)
    : QWidget(parent), m_jobs(jobs), m_title(new QLabel), m_bar(new QProgressBar) {
    m_bar->setRange(0, 1000);
    m_bar->setTextVisible(false);
    m_bar->setFixedSize(160, 6);
    auto* cancel = widgets::makeToolButton("cancel", tr("Cancel"), tr("Cancel what is running"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(m_title);
    layout->addWidget(m_bar, 0, Qt::AlignVCenter);
    layout->addWidget(cancel);

    m_delay.setSingleShot(true);
    m_delay.setInterval(150);
    connect(&m_delay, &QTimer::timeout, this, [this] {
        showProgress();
        show();
    });
    connect(cancel, &QToolButton::clicked, &jobs, &JobRunner::cancelAll);
    connect(&jobs, &JobRunner::jobsChanged, this, &JobStatus::follow);
    connect(&jobs, &JobRunner::progressed, this, &JobStatus::showProgress);
    hide();
}

void JobStatus::follow() {
    if (m_jobs.jobs().empty()) {
        m_delay.stop();
        hide();
    } else if (!isVisible() && !m_delay.isActive()) {
        m_delay.start();
    }
    showProgress();
}

void JobStatus::showProgress() {
    const auto jobs = m_jobs.jobs();
    if (jobs.empty()) return;
    const QString more = jobs.size() > 1 ? tr(" (%1 more)").arg(jobs.size() - 1) : QString();
    m_title->setText(jobs.front().title + more);
    m_bar->setValue(int(jobs.front().progress * 1000));
}

}  // namespace chiaro::app
