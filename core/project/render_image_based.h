#pragma once

#include "core/project/animation.h"

#include <nlohmann/json_fwd.hpp>

namespace chiaro::project {

/// The image-based method's row of the table of render methods.
Rendering renderImageBased(const Project& project, const WornPaints& worn, const scene::GBuffer& gbuffer,
                           const Task& task);
std::unique_ptr<FramePainter> animateImageBased(const Shot& shot, ShotViews& views);
nlohmann::json imageBasedParameters(const Project& project);

}  // namespace chiaro::project
