#pragma once

#include "core/project/animation.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>

namespace chiaro::project {

/// A way to lay paint on a picture (§4): one row of the table that the project file, the command line and the
/// studio choose from.
struct RenderMethod {
    std::string key;    ///< in project files and after --method
    std::string label;  ///< in the studio
    bool usesLevels;    ///< needs the level stack of every sample
    bool usesViews;     ///< needs textures of every object's own views
    bool takesGuides;   ///< needs nothing of a view but light and object ids
    Rendering (*render)(const Project& project, const WornPaints& worn, const scene::GBuffer& gbuffer,
                        const Task& task);
    std::unique_ptr<FramePainter> (*animate)(const Shot& shot, ShotViews& views);
    nlohmann::json (*parameters)(const Project& project);  ///< those that its pictures depend on
};

std::span<const RenderMethod> renderMethods();
/// Null for a key that no method has.
const RenderMethod* findRenderMethod(std::string_view key);
/// Throws Error naming the methods that there are.
const RenderMethod& renderMethod(std::string_view key);

}  // namespace chiaro::project
