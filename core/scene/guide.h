#pragma once

#include "core/scene/gbuffer.h"

namespace chiaro::scene {

/// A view that pictures describe instead of a mesh: light in [0, 1] (more counts as 1; NaN, infinite and
/// negative values are outside) and object ids (0 is outside; without a picture of them all is object 1). It
/// has no finer samples, no eye, and faceId, barycentrics, depth and normal stay empty. Throws Error when the
/// pictures have no pixel or differ in size.
GBuffer gbufferFromGuide(const ScalarImage& light, const IdImage* ids = nullptr);

}  // namespace chiaro::scene
