#pragma once

#include "app/change.h"
#include "core/scene/path.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <deque>
#include <optional>

namespace chiaro::app {

class Document;
class Meshes;

/// The frame of the document's animation that is shown, and playing it. Needs no window.
class Playback : public QObject {
    Q_OBJECT

public:
    Playback(Document& document, Meshes& meshes, QObject* parent = nullptr);

    int currentFrame() const { return m_frame; }
    bool isPlaying() const { return m_timer.isActive(); }
    /// The camera and the lights of the current frame; where the artist looked elsewhere since, that camera.
    scene::View view() const;

    /// What a key made now holds: the camera as it is shown, without the turn that goes on top of keys; and
    /// the first light likewise.
    scene::Camera cameraKey() const;
    glm::vec3 lightKey() const;

    /// The artist looks elsewhere: kept as the view that turns start from. Keys win at the next frame.
    void takeCamera(const scene::Camera& shown);
    /// The artist turned a light at this frame: where the first light has keys it gets one here, else the
    /// light itself is changed.
    void takeLight(int light, glm::vec3 shown);

public Q_SLOTS:
    void setCurrentFrame(int frame);
    /// Plays the render range over and over, in time: what is too slow to show is left out.
    void setPlaying(bool playing);
    /// To be called whenever a picture was shown, for the rate.
    void countPicture();

Q_SIGNALS:
    void currentFrameChanged(int frame);
    void playingChanged(bool playing);
    /// Another camera or other lights are to be shown.
    void viewChanged();
    /// Pictures a second over the last second, while playing.
    void rateMeasured(double rate);

private:
    void applyChange(Change change);
    void advance();
    glm::vec3 unturned(glm::vec3 vector, const scene::Light& light) const;
    scene::Camera unturned(scene::Camera camera) const;

    Document& m_document;
    Meshes& m_meshes;
    int m_frame = 1;
    scene::Path m_cameraPath;              ///< what moves the camera, as it was shown last
    std::optional<scene::Camera> m_shown;  ///< where the artist looked since the frame was shown
    QTimer m_timer;
    QElapsedTimer m_clock;  ///< since playing began at m_start
    int m_start = 1;
    std::deque<qint64> m_pictures;  ///< when they were shown, ms
};

}  // namespace chiaro::app
