#pragma once

#include "app/change.h"
#include "core/scene/mesh.h"

#include <QObject>

#include <memory>
#include <vector>

namespace chiaro::widgets {
class Viewport;
}

namespace chiaro::app {

class Document;
class FrameTextures;
class Meshes;
class ObjectTextures;
class Paints;
class Playback;

/// Keeps the viewport showing the document at its current frame, and takes back what the artist does in it:
/// the camera, the light.
class ViewportLink : public QObject {
    Q_OBJECT

public:
    ViewportLink(Document& document, Playback& playback, Paints& paints, Meshes& meshes,
                 FrameTextures& textures, ObjectTextures& objectTextures, widgets::Viewport& viewport,
                 QObject* parent = nullptr);

private:
    void applyChange(Change change);
    void showScene();
    void showPaint(int sample);
    void showFrame();

    Document& m_document;
    Playback& m_playback;
    Paints& m_paints;
    Meshes& m_meshes;
    FrameTextures& m_textures;
    widgets::Viewport& m_viewport;
    int m_shownSamples = 0;
    bool m_movesCamera = false;  ///< the animation did when the frame was shown last
    std::vector<std::shared_ptr<const scene::Mesh>> m_framed;  ///< that the camera was aimed at
};

}  // namespace chiaro::app
