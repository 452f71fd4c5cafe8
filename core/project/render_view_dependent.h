#pragma once

#include "core/project/animation.h"

#include <nlohmann/json_fwd.hpp>

namespace chiaro::project {

/// The view-dependent method's row of the table of render methods.
Rendering renderViewDependent(const Project& project, const WornPaints& worn, const scene::GBuffer& gbuffer,
                              const Task& task);
std::unique_ptr<FramePainter> animateViewDependent(const Shot& shot, ShotViews& views);
nlohmann::json viewDependentParameters(const Project& project);

}  // namespace chiaro::project
