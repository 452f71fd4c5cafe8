#pragma once

#include "core/project/animation.h"

#include <nlohmann/json_fwd.hpp>

namespace chiaro::project {

/// The view-aligned method's row of the table of render methods.
Rendering renderViewAligned(const Project& project, const WornPaints& worn, const scene::GBuffer& gbuffer,
                            const Task& task);
std::unique_ptr<FramePainter> animateViewAligned(const Shot& shot, ShotViews& views);
nlohmann::json viewAlignedParameters(const Project& project);

}  // namespace chiaro::project
