#pragma once

#include "core/base/task.h"
#include "core/project/project.h"
#include "core/scene/gbuffer.h"

#include <memory>
#include <vector>

namespace chiaro::project {

/// What one sample becomes on its way from the scan to the brush.
struct Paint {
    ColorImage strip;
    gradient::Separation separation;
    gradient::Gradient shown;  ///< the artist's recolouring, or else the sample's own gradient G(u(x))
    synthesis::LevelStack levels;
    double levelSeconds = 0;  ///< what the level stack took to make
};

/// The gradient that pictures show for a sample.
gradient::Gradient shownGradient(const Sample& sample, const gradient::Separation& separation);

/// Scan, strip, separation and level stack of a sample. Throws Error, Cancelled.
Paint preparePaint(const Sample& sample, const synthesis::LevelParams& levels, const Task& task = {});

/// The scene of a loaded model with the project's settings applied: objects are matched by name; those that
/// the project does not name wear its first sample.
scene::Scene makeScene(const Project& project, const std::vector<std::shared_ptr<const scene::Mesh>>& meshes);

/// The project's camera, aimed at the scene when the project says so.
scene::Camera cameraFor(const Project& project, const scene::Scene& scene);

/// The picture of a view by the project's method, the texture where it lies when the objects are first seen.
/// `paints` has one entry a sample of the project, `gbuffer` shows `scene`. Throws Cancelled.
methods::Frame renderFrame(const Project& project, const scene::Scene& scene,
                           const std::vector<Paint>& paints, const scene::GBuffer& gbuffer,
                           const Task& task = {});

}  // namespace chiaro::project
