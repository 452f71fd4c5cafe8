#pragma once

#include "core/scene/scene.h"

#include <QPointF>
#include <QSizeF>

#include <optional>

namespace chiaro::widgets {

/// The index of the object nearest to the eye at a point of the widget (pixels, y down), if there is one.
/// Tries every triangle: a few milliseconds for half a million, and nothing to keep up to date.
std::optional<std::size_t> objectAt(const scene::Scene& scene, const scene::Camera& camera, QPointF point,
                                    QSizeF viewport);

}  // namespace chiaro::widgets
