#include "app/project_collector.h"

#include "app/document.h"
#include "app/jobs/job_runner.h"
#include "app/replace_question.h"
#include "core/project/collect.h"

#include <QtWidgets>

namespace chiaro::app {

ProjectCollector::ProjectCollector(Document& document, JobRunner& jobs, QWidget& window)
    : QObject(&window), m_document(document), m_jobs(jobs), m_window(window) {}

void ProjectCollector::collect(const QString& folder) {
    const QString chosen = QFileDialog::getExistingDirectory(&m_window, tr("Collect Files: Choose a Folder"),
                                                             folder, QFileDialog::ShowDirsOnly);
    if (!chosen.isEmpty()) collectInto(chosen.toStdString());
}

void ProjectCollector::collectInto(const std::filesystem::path& folder) {
    const std::string name = m_document.name().toStdString() + ".chiaro";
    // Finding the files that meshes name reads them: not on the window's thread.
    m_jobs.start(
        {tr("Looking for the project's files"), "collect", {}, {}},
        [project = m_document.project(), file = folder / name](const Task&) {
            return project::planCollection(project, file);
        },
        [this, folder](const project::Collection& collection) {
            if (!mayReplace(m_window, collection.targets(), tr("Collect Files"))) return;
            m_jobs.start(
                {tr("Collecting files"), "collect", {}, {}},
                [collection](const Task& task) {
                    project::collectFiles(collection, task);
                    return true;
                },
                [this, folder, left = collection.left](bool) {
                    QString note = tr("Everything is at %1").arg(QString::fromStdString(folder.string()));
                    QStringList names;
                    for (const std::filesystem::path& file : left)
                        names << QString::fromStdString(file.filename().string());
                    if (!names.isEmpty())
                        note = tr("The project is at %1, without what is missing: %2")
                                   .arg(QString::fromStdString(folder.string()), names.join(", "));
                    Q_EMIT collected(note);
                });
        });
}

}  // namespace chiaro::app
