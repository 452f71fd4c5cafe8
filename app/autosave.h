#pragma once

#include "core/project/project.h"

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <vector>

namespace chiaro::app {

class Document;

/// Keeps a copy of the document's changes outside the project, in case the studio ends before they are saved.
///
/// The first change is kept at once, later ones after `seconds` or `edits`, whichever comes first; saving the
/// project removes the copy. Files are written on a thread of their own, whole or not at all. Every studio
/// that runs has copies of its own; those of one that runs no more are left over, to be offered at the next
/// start.
class Autosave : public QObject {
    Q_OBJECT

public:
    struct Rhythm {
        double seconds = 60;
        int edits = 25;
    };
    /// `folder` may not exist yet.
    Autosave(Document& document, std::filesystem::path folder, Rhythm rhythm, QObject* parent = nullptr);
    /// Removes the copy: who ends the studio was asked about changes before.
    ~Autosave() override;

    /// What a studio that ended left.
    struct Leftover {
        std::filesystem::path kept;
        std::filesystem::path original;  ///< the project that was changed; empty when it never was saved
        QString name;                    ///< what the artist knows it by
        QDateTime time;                  ///< of its last change that was kept
    };
    /// The latest first.
    std::vector<Leftover> leftovers() const;
    void discard(const Leftover& leftover);
    /// The document has become this leftover: it is kept as the document's own copy, then discarded.
    void takeOver(const Leftover& leftover);

    /// Waits until all is on the disk that was to be written so far.
    void flush();
    /// Where copies go: $XDG_STATE_HOME/chiaro/autosave, or the platform's like.
    static std::filesystem::path standardFolder();

Q_SIGNALS:
    /// A copy is on the disk.
    void kept(const QDateTime& time);
    /// Nothing is kept any more: all is saved.
    void cleared();
    void failed(const QString& message);

private:
    void noteEdit();
    void follow();
    /// `replaced`: a copy to remove once this one is written.
    void keep(std::filesystem::path replaced = {});
    void clear();

    Document& m_document;
    std::filesystem::path m_folder;
    Rhythm m_rhythm;
    std::filesystem::path m_copy;
    std::unique_ptr<QLockFile> m_lock;  ///< tells others that this studio runs
    QTimer m_soon;
    int m_edits = 0;  ///< since the last copy
    bool m_hasCopy = false;
    bool m_isNoted = false;  ///< follow() is on its way
    QThreadPool m_writer;    ///< one thread, so that files are written in order
};

}  // namespace chiaro::app
