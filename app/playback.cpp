#include "app/playback.h"

#include "app/document.h"
#include "app/meshes.h"
#include "core/project/pipeline.h"

#include <glm/gtc/matrix_transform.hpp>

#include <QtWidgets>

#include <algorithm>

namespace chiaro::app {

Playback::Playback(Document& document, Meshes& meshes, QObject* parent)
    : QObject(parent), m_document(document), m_meshes(meshes) {
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Playback::advance);
    connect(&document, &Document::changed, this, &Playback::applyChange);
}

scene::View Playback::view() const {
    const project::Project& project = m_document.project();
    scene::View view =
        project.animation.path.at(m_frame, {project::cameraFor(project, m_meshes.scene()), project.lights});
    if (m_shown) view.camera = *m_shown;
    return view;
}

scene::Camera Playback::unturned(scene::Camera camera) const {
    camera.azimuth -= float(m_document.project().animation.path.cameraTurn * (m_frame - 1));
    return camera;
}

void Playback::takeCamera(const scene::Camera& shown) {
    m_shown = shown;
    m_document.setCamera(unturned(shown));
}

scene::Camera Playback::cameraKey() const {
    return unturned(view().camera);
}

glm::vec3 Playback::lightKey() const {
    const scene::View shown = view();
    return shown.lights.empty() ? glm::vec3(0, 0, 1)
                                : unturned(shown.lights.front().vector, shown.lights.front());
}

glm::vec3 Playback::unturned(glm::vec3 vector, const scene::Light& light) const {
    const double turn = m_document.project().animation.path.lightTurn * (m_frame - 1);
    const glm::vec3 axis = light.kind == scene::Light::Kind::Point ? view().camera.target : glm::vec3(0);
    const glm::mat3 back(glm::rotate(glm::mat4(1), float(-glm::radians(turn)), glm::vec3(0, 1, 0)));
    return turn == 0 ? vector : axis + back * (vector - axis);
}

void Playback::takeLight(int light, glm::vec3 shown) {
    const project::Project& project = m_document.project();
    const glm::vec3 vector = unturned(shown, project.lights[std::size_t(light)]);
    if (light != 0 || project.animation.path.keyFrames(scene::Path::Part::Light).empty())
        return m_document.editLight(light, vector);
    project::Animation animation = project.animation;
    animation.path.setKey(m_frame, vector);
    m_document.editAnimation(animation, tr("Key Light"));
}

void Playback::setCurrentFrame(int frame) {
    frame = std::clamp(frame, 1, m_document.project().animation.frames);
    if (frame == m_frame) return;
    m_frame = frame;
    m_shown.reset();
    if (isPlaying()) {
        m_start = frame;
        m_clock.restart();
        m_pictures.clear();
    }
    Q_EMIT currentFrameChanged(frame);
    Q_EMIT viewChanged();
}

void Playback::setPlaying(bool playing) {
    if (playing == isPlaying()) return;
    if (playing) {
        const project::Animation& animation = m_document.project().animation;
        m_start = m_frame;
        m_clock.start();
        m_pictures.clear();
        m_timer.start(std::max(1, int(1000 / animation.rate)));
    } else {
        m_timer.stop();
    }
    Q_EMIT playingChanged(playing);
}

void Playback::advance() {
    const project::Animation& animation = m_document.project().animation;
    const int count = animation.lastFrame - animation.firstFrame + 1;
    const auto gone = int(double(m_clock.elapsed()) * animation.rate / 1000);
    const int from = std::clamp(m_start, animation.firstFrame, animation.lastFrame) - animation.firstFrame;
    const int frame = animation.firstFrame + (from + gone) % count;
    if (frame == m_frame) return;
    m_frame = frame;
    m_shown.reset();
    Q_EMIT currentFrameChanged(frame);
    Q_EMIT viewChanged();
}

void Playback::countPicture() {
    if (!isPlaying()) return;
    constexpr qint64 second = 1000;
    const qint64 now = m_clock.elapsed();
    m_pictures.push_back(now);
    while (m_pictures.front() < now - second) m_pictures.pop_front();
    if (now - m_pictures.front() < second / 4) return;  // too little to tell
    Q_EMIT rateMeasured(double(m_pictures.size() - 1) * 1000 / double(now - m_pictures.front()));
}

void Playback::applyChange(Change change) {
    using Kind = Change::Kind;
    if (change.kind == Kind::Everything) {
        setPlaying(false);
        m_frame = 1;
        m_shown.reset();
        Q_EMIT currentFrameChanged(1);
        Q_EMIT viewChanged();
    }
    const project::Animation& animation = m_document.project().animation;
    if (change.kind == Kind::Everything || change.kind == Kind::Animation) {
        scene::Path camera = animation.path;
        camera.light = {};
        camera.lightTurn = 0;
        if (std::exchange(m_cameraPath, camera) != camera) m_shown.reset();
    }
    if (change.kind == Kind::Animation) {
        if (isPlaying()) m_timer.setInterval(std::max(1, int(1000 / animation.rate)));
        setCurrentFrame(m_frame);  // there may be fewer
        Q_EMIT viewChanged();
    }
    if (change.kind == Kind::Lights) Q_EMIT viewChanged();
}

}  // namespace chiaro::app
