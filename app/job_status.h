#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;

namespace chiaro::app {

class JobRunner;

/// What is running, how far it is, and a button that cancels it. Hidden while nothing runs, and for work too
/// short to read about.
class JobStatus : public QWidget {
    Q_OBJECT

public:
    explicit JobStatus(JobRunner& jobs, QWidget* parent = nullptr);

private:
    void follow();
    void showProgress();

    JobRunner& m_jobs;
    QLabel* m_title = nullptr;
    QProgressBar* m_bar = nullptr;
    QTimer m_delay;
};

}  // namespace chiaro::app
