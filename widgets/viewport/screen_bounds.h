#pragma once

#include "core/scene/camera.h"
#include "core/scene/scene.h"

#include <QRect>

namespace chiaro::widgets {

/// The pixels (y down) that an object with these bounds in object space can cover; the whole picture when it
/// reaches behind the eye, empty when it lies beside the picture.
QRect screenBounds(const scene::Bounds& bounds, const glm::mat4& objectToClip, QSize pixels);

}  // namespace chiaro::widgets
