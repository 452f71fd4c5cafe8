#pragma once

#include "app/picture_export.h"

#include <QObject>

class QWidget;

namespace chiaro::widgets {
class Viewport;
}

namespace chiaro::app {

class Document;
class JobRunner;
class Meshes;
class ObjectTextures;
class Paints;
class Playback;

/// What the artist takes out of the studio: asks how, and makes it in the background from a snapshot, by core
/// and never from the screen.
class Exporter : public QObject {
    Q_OBJECT

public:
    /// Dialogs appear over the viewport's window.
    Exporter(Document& document, JobRunner& jobs, Paints& paints, Meshes& meshes, ObjectTextures& textures,
             Playback& playback, widgets::Viewport& viewport, QObject* parent);

    /// `folder` is where files are suggested to go.
    void exportPicture(const QString& folder);
    void renderAnimation(const QString& folder);
    void exportMesh(const QString& folder);
    void exportPage(const QString& folder);

Q_SIGNALS:
    /// What was written, and where.
    void exported(const QString& note);

private:
    PictureSource source() const;
    std::filesystem::path suggestion(const QString& folder, const char* extension) const;

    Document& m_document;
    JobRunner& m_jobs;
    Paints& m_paints;
    Meshes& m_meshes;
    ObjectTextures& m_textures;
    Playback& m_playback;
    widgets::Viewport& m_viewport;
};

}  // namespace chiaro::app
