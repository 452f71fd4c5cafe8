#pragma once

#include <QDockWidget>

class QToolButton;
class QTreeView;

namespace chiaro::app {

class JobModel;
class JobRunner;

/// Every long work: how far it is, how long it still takes, a way to cancel it, and why it failed.
class JobsDock : public QDockWidget {
    Q_OBJECT

public:
    explicit JobsDock(JobRunner& jobs);

    JobModel& model() { return *m_model; }
    QTreeView* list() const { return m_list; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void cancelSelected();
    void showButtons();

    JobModel* m_model = nullptr;
    QTreeView* m_list = nullptr;
    QToolButton* m_cancel = nullptr;
    QToolButton* m_cancelAll = nullptr;
};

}  // namespace chiaro::app
