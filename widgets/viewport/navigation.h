#pragma once

#include "core/scene/camera.h"

#include <QPointF>
#include <QSizeF>
#include <Qt>

#include <optional>

namespace chiaro::widgets {

/// Which gestures turn, pan and zoom. In all of them a plain left drag turns, Shift and the right button turn
/// the light, and the wheel zooms unless said otherwise.
enum class Navigation {
    Blender,  ///< middle turns, Shift + middle pans, Ctrl + middle zooms
    Maya,     ///< Alt + left turns, Alt + middle pans, Alt + right zooms
    Trackpad  ///< two fingers turn, with Shift pan, with Ctrl (or pinching) zoom
};

/// What a gesture does.
enum class Gesture { None, Orbit, Pan, Zoom, Light };

Gesture dragGesture(Navigation navigation, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);
Gesture scrollGesture(Navigation navigation, Qt::KeyboardModifiers modifiers);

// What the gestures do to the camera. Positions and deltas are in widget pixels, y down, `viewport` is the
// widget's size.

/// The object follows the mouse; elevation stops at the poles.
scene::Camera orbited(const scene::Camera& camera, QPointF delta);
/// The target's plane follows the mouse exactly.
scene::Camera panned(const scene::Camera& camera, QPointF delta, QSizeF viewport);
/// Multiplies the distance by `factor`, within its range; what lies under the cursor at the target's depth
/// stays there.
scene::Camera zoomed(const scene::Camera& camera, float factor, QPointF cursor, QSizeF viewport);
/// The factor of a wheel's turn in eighths of a degree (a notch is 120) or of a vertical drag in pixels, any
/// fraction.
float wheelZoomFactor(float eighths);
float dragZoomFactor(float pixels);

/// A light's vector turned so that the lit side follows the mouse as seen from the camera.
glm::vec3 turnedLight(glm::vec3 vector, const scene::Camera& camera, QPointF delta);
/// The vector of a light that lights up this point of a sphere that fills the viewport; beyond its rim the
/// light goes behind.
glm::vec3 lightAt(const scene::Camera& camera, QPointF point, QSizeF viewport);

/// The camera after a key, if it is one of ours: numpad 1, 3, 7 look from the front, the right, the top (with
/// Ctrl from the other side), 9 from the opposite side, 2, 4, 6, 8 turn by 15 degrees, 5 flattens the
/// perspective and back; arrows turn by 5 degrees, with Shift pan; plus and minus zoom.
std::optional<scene::Camera> keyMoved(const scene::Camera& camera, int key, Qt::KeyboardModifiers modifiers,
                                      QSizeF viewport);

}  // namespace chiaro::widgets
