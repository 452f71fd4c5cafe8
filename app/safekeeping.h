#pragma once

#include "app/autosave.h"
#include "app/project_lock.h"

#include <QObject>

class QLabel;
class QWidget;

namespace chiaro::app {

class Document;
class Opener;

/// What keeps an artist's work from getting lost, and asks when something is amiss: autosave and recovery,
/// the lock of the open project, files that are missing. A label says when changes were kept last.
class Safekeeping : public QObject {
    Q_OBJECT

public:
    Safekeeping(Document& document, Opener& opener, std::filesystem::path folder, QWidget& window);

    QLabel* label() const { return m_label; }
    Autosave& autosave() { return m_autosave; }
    /// Offers what was left over; true when the artist takes it.
    bool offerRecovery();

private:
    bool askMissing(project::Project& project);
    bool askLocked(const std::filesystem::path& path);

    Document& m_document;
    Opener& m_opener;
    QWidget& m_window;
    Autosave m_autosave;
    ProjectLock m_lock;
    QLabel* m_label = nullptr;
};

}  // namespace chiaro::app
