#pragma once

#include <QObject>
#include <QStringList>

class QWidget;

namespace chiaro::app {

class Document;
class Opener;
class RecentFiles;

/// Asks the artist which files to open and where to save the project, over a window.
class ProjectFiles : public QObject {
    Q_OBJECT

public:
    ProjectFiles(Document& document, Opener& opener, QWidget& window);

    void newProject();
    void openProject();
    void openStrip();
    void openMesh();
    void addMesh();
    /// Of a project that is read-only as saveAs(). False when the artist changed their mind or the disk
    /// refused.
    bool save();
    bool saveAs();
    /// Asks about changes that would get lost; false when the artist wants to keep them after all.
    bool mayDiscard();

    /// Where the artist's files go: beside the project, or to their documents.
    QString folder() const;
    RecentFiles& recent() { return *m_recent; }

Q_SIGNALS:
    void failed(const QString& message);
    void noted(const QString& note);
    void saved();

private:
    QStringList chosen(const QString& title, const QString& filter) const;
    void open(const QString& title, const QString& filter);
    bool saveTo(const QString& path);

    Document& m_document;
    Opener& m_opener;
    QWidget& m_window;
    RecentFiles* m_recent = nullptr;
};

}  // namespace chiaro::app
