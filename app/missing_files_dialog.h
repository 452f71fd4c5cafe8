#pragma once

#include "core/project/objects.h"

#include <QDialog>
#include <QFutureWatcher>

#include <stop_token>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace chiaro::app {

/// The files that a project names and that are not there, and ways to say where they are now: a file, which
/// helps to find the others beside it, or a folder that is searched for all of them.
class MissingFilesDialog : public QDialog {
    Q_OBJECT

public:
    /// The project is changed as files are found; it must stay.
    explicit MissingFilesDialog(project::Project& project, QWidget* parent = nullptr);

    ~MissingFilesDialog() override;

    QTreeWidget* list() const { return m_list; }
    /// Looks for all that is missing in a folder and below, in the background.
    void search(const QString& folder);

Q_SIGNALS:
    void searched();

private:
    void showMissing(const std::vector<project::MissingFile>& missing);
    void findSelected();
    void chooseFolder();

    project::Project& m_project;
    std::vector<project::MissingFile> m_missing;
    QTreeWidget* m_list = nullptr;
    QLabel* m_text = nullptr;
    QPushButton* m_find = nullptr;
    QPushButton* m_searchButton = nullptr;
    std::stop_source m_stop;
    QFutureWatcher<project::Project> m_search;
    QPushButton* m_open = nullptr;
};

}  // namespace chiaro::app
