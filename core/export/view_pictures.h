#pragma once

#include "core/export/surface_light.h"
#include "core/methods/view_dependent.h"

namespace chiaro::exporting {

/// Paints the picture that a guide of light and object ids asks for, by some method.
using GuidePainter = std::function<methods::Frame(const scene::GBuffer& guide, const Task& task)>;

/// The textures of an object's views for a method that paints pictures, not surfaces (§4.1, §4.2): each view
/// of its plan is painted in that light, and what the method adds to G(L) there becomes the view's
/// only level. `object` is its index in the scene; guides show it as object `object` + 1. Deterministic if
/// the painter is. Throws what the painter throws, Cancelled.
methods::ViewTextures paintViews(const methods::PlannedObject& planned, const methods::ViewWeights& weights,
                                 std::size_t object, const SurfaceLight& light, const GuidePainter& painter,
                                 const Task& task = {});

}  // namespace chiaro::exporting
