#pragma once

#include "core/base/image.h"
#include "core/gradient/gradient.h"

#include <QColor>
#include <QImage>

namespace chiaro::widgets {

/// Core's colours and pictures as Qt's. Display-referred RGB in [0, 1] on core's side; values outside are
/// clipped. Thread-safe.
QColor toColor(glm::vec3 color);
glm::vec3 fromColor(const QColor& color);

/// Adds `offset` to every channel first: +0.5 shows a difference image (§3.2).
QImage toImage(const ColorImage& image, float offset = 0);
/// The gradient as a picture one pixel high.
QImage toImage(const gradient::Gradient& gradient);

/// The picture averaged down by whole factors so that it is at most as large as given; itself when it is.
ColorImage reduced(const ColorImage& image, int maximumWidth, int maximumHeight);

}  // namespace chiaro::widgets
