#pragma once

#include "core/project/objects.h"

#include <QDialog>

class QPushButton;
class QTreeWidget;

namespace chiaro::app {

/// The files that a project names and that are not there, and a way to say where they are now. One that is
/// found helps to find the others beside it.
class MissingFilesDialog : public QDialog {
    Q_OBJECT

public:
    /// The project is changed as files are found; it must stay.
    explicit MissingFilesDialog(project::Project& project, QWidget* parent = nullptr);

    QTreeWidget* list() const { return m_list; }

private:
    void show(const std::vector<project::MissingFile>& missing);
    void findSelected();

    project::Project& m_project;
    std::vector<project::MissingFile> m_missing;
    QTreeWidget* m_list = nullptr;
    QPushButton* m_find = nullptr;
    QPushButton* m_open = nullptr;
};

}  // namespace chiaro::app
