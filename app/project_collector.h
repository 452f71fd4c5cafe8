#pragma once

#include <QObject>

#include <filesystem>

class QWidget;

namespace chiaro::app {

class Document;
class JobRunner;

/// Asks for a folder, and copies the project and all that it needs there in the background. The project that
/// is open stays the one that it is.
class ProjectCollector : public QObject {
    Q_OBJECT

public:
    ProjectCollector(Document& document, JobRunner& jobs, QWidget& window);

    /// `folder` is where the question begins.
    void collect(const QString& folder);
    /// Without the question for the folder; asks before it replaces files.
    void collectInto(const std::filesystem::path& folder);

Q_SIGNALS:
    /// Where everything is now, and what is missing there.
    void collected(const QString& note);

private:
    Document& m_document;
    JobRunner& m_jobs;
    QWidget& m_window;
};

}  // namespace chiaro::app
