#define GLM_ENABLE_EXPERIMENTAL

#include "widgets/viewport/navigation.h"

#include <glm/gtx/rotate_vector.hpp>

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr float orbitDegreesPerPixel = 0.4f;
constexpr float lightDegreesPerPixel = 0.5f;
constexpr float perspectiveFieldOfView = 30;
constexpr float flatFieldOfView = 2;

struct ViewAxes {
    glm::vec3 right;
    glm::vec3 up;
    glm::vec3 towardsEye;
};

ViewAxes axesOf(const scene::Camera& camera) {
    const glm::mat3 basis = camera.basis();
    return {basis[0], basis[1], basis[2]};
}

/// World units a pixel in the plane through the target.
float unitsPerPixel(const scene::Camera& camera, QSizeF viewport) {
    const double side = std::max(1.0, std::min(viewport.width(), viewport.height()));
    return 2 * camera.eyeDistance() * std::tan(glm::radians(camera.fieldOfView) / 2) / float(side);
}

float wrappedDegrees(float angle) {
    return angle - 360 * std::floor((angle + 180) / 360);
}

scene::Camera turned(scene::Camera camera, float azimuth, float elevation) {
    camera.azimuth = wrappedDegrees(camera.azimuth + azimuth);
    camera.elevation = std::clamp(camera.elevation + elevation, -90.0f, 90.0f);
    return camera;
}

scene::Camera lookingFrom(scene::Camera camera, float azimuth, float elevation) {
    camera.azimuth = wrappedDegrees(azimuth);
    camera.elevation = elevation;
    return camera;
}

std::optional<scene::Camera> numpadMoved(const scene::Camera& camera, int key, bool opposite) {
    const bool atPole = std::abs(camera.elevation) == 90;
    switch (key) {
        case Qt::Key_1:
            return lookingFrom(camera, opposite ? 180.0f : 0.0f, 0);
        case Qt::Key_3:
            return lookingFrom(camera, opposite ? -90.0f : 90.0f, 0);
        case Qt::Key_7:
            return lookingFrom(camera, 0, opposite ? -90.0f : 90.0f);
        case Qt::Key_9:
            return lookingFrom(camera, camera.azimuth + (atPole ? 0.0f : 180.0f), -camera.elevation);
        case Qt::Key_2:
            return turned(camera, 0, -15);
        case Qt::Key_4:
            return turned(camera, -15, 0);
        case Qt::Key_6:
            return turned(camera, 15, 0);
        case Qt::Key_8:
            return turned(camera, 0, 15);
        case Qt::Key_5: {
            scene::Camera flattened = camera;
            flattened.fieldOfView =
                camera.fieldOfView > flatFieldOfView ? flatFieldOfView : perspectiveFieldOfView;
            return flattened;
        }
        default:
            return std::nullopt;
    }
}

std::optional<QPointF> arrow(int key) {
    switch (key) {
        case Qt::Key_Left:
            return QPointF(-1, 0);
        case Qt::Key_Right:
            return QPointF(1, 0);
        case Qt::Key_Up:
            return QPointF(0, -1);
        case Qt::Key_Down:
            return QPointF(0, 1);
        default:
            return std::nullopt;
    }
}

}  // namespace

Gesture dragGesture(Navigation navigation, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    modifiers &= Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier;
    if (button == Qt::RightButton && modifiers == Qt::ShiftModifier) return Gesture::Light;
    if (button == Qt::LeftButton && modifiers == Qt::NoModifier) return Gesture::Orbit;
    if (navigation == Navigation::Blender && button == Qt::MiddleButton) {
        if (modifiers == Qt::NoModifier) return Gesture::Orbit;
        if (modifiers == Qt::ShiftModifier) return Gesture::Pan;
        if (modifiers == Qt::ControlModifier) return Gesture::Zoom;
    }
    if (navigation == Navigation::Maya && modifiers == Qt::AltModifier) {
        if (button == Qt::LeftButton) return Gesture::Orbit;
        if (button == Qt::MiddleButton) return Gesture::Pan;
        if (button == Qt::RightButton) return Gesture::Zoom;
    }
    return Gesture::None;
}

Gesture scrollGesture(Navigation navigation, Qt::KeyboardModifiers modifiers) {
    if (navigation != Navigation::Trackpad || modifiers & Qt::ControlModifier) return Gesture::Zoom;
    return modifiers & Qt::ShiftModifier ? Gesture::Pan : Gesture::Orbit;
}

scene::Camera orbited(const scene::Camera& camera, QPointF delta) {
    return turned(camera, -orbitDegreesPerPixel * float(delta.x()), orbitDegreesPerPixel * float(delta.y()));
}

scene::Camera panned(const scene::Camera& camera, QPointF delta, QSizeF viewport) {
    const ViewAxes axes = axesOf(camera);
    const float units = unitsPerPixel(camera, viewport);
    scene::Camera moved = camera;
    moved.target += units * (axes.up * float(delta.y()) - axes.right * float(delta.x()));
    return moved;
}

scene::Camera zoomed(const scene::Camera& camera, float factor, QPointF cursor, QSizeF viewport) {
    scene::Camera moved = camera;
    moved.distance = std::clamp(camera.distance * factor, 0.01f, 100.0f);
    const float applied = moved.distance / camera.distance;
    const QPointF fromCentre = cursor - QPointF(viewport.width(), viewport.height()) / 2;
    // The plane through the target shrinks by `applied` about the cursor's point in it.
    return panned(moved, fromCentre - fromCentre / double(applied), viewport);
}

float wheelZoomFactor(float eighths) {
    return std::exp2(-eighths / 120 / 4);
}

float dragZoomFactor(float pixels) {
    return std::exp2(pixels / 100);
}

glm::vec3 turnedLight(glm::vec3 vector, const scene::Camera& camera, QPointF delta) {
    const ViewAxes axes = axesOf(camera);
    const glm::vec3 aside =
        glm::rotate(vector, glm::radians(lightDegreesPerPixel * float(delta.x())), axes.up);
    return glm::rotate(aside, glm::radians(lightDegreesPerPixel * float(delta.y())), axes.right);
}

glm::vec3 lightAt(const scene::Camera& camera, QPointF point, QSizeF viewport) {
    const ViewAxes axes = axesOf(camera);
    const float radius = float(std::max(1.0, std::min(viewport.width(), viewport.height()))) / 2;
    glm::vec2 at(float(point.x() - viewport.width() / 2) / radius,
                 float(viewport.height() / 2 - point.y()) / radius);
    float towardsEye = 1;
    const float length = glm::length(at);
    if (length > 1) {
        towardsEye = -1;
        at *= std::max(0.0f, 2 - length) / length;
    }
    towardsEye *= std::sqrt(std::max(0.0f, 1 - glm::dot(at, at)));
    return axes.right * at.x + axes.up * at.y + axes.towardsEye * towardsEye;
}

std::optional<scene::Camera> keyMoved(const scene::Camera& camera, int key, Qt::KeyboardModifiers modifiers,
                                      QSizeF viewport) {
    const QPointF centre(viewport.width() / 2, viewport.height() / 2);
    if (key == Qt::Key_Plus) return zoomed(camera, wheelZoomFactor(120), centre, viewport);
    if (key == Qt::Key_Minus) return zoomed(camera, wheelZoomFactor(-120), centre, viewport);
    // A numpad without num lock sends arrows; they turn just as the plain ones do.
    if (const auto direction = arrow(key)) {
        if (modifiers & Qt::ShiftModifier) return panned(camera, *direction * -20, viewport);
        return turned(camera, 5 * float(direction->x()), -5 * float(direction->y()));
    }
    if (modifiers & Qt::KeypadModifier) return numpadMoved(camera, key, modifiers & Qt::ControlModifier);
    return std::nullopt;
}

}  // namespace chiaro::widgets
