#pragma once

#include "core/base/task.h"
#include "core/project/animation_output.h"
#include "core/project/project.h"

#include <filesystem>

namespace chiaro::app {

/// Where a project's animation is written to, and how large.
struct AnimationSettings {
    std::filesystem::path output;  ///< name.####.png (.tif, .exr), #### being the frame; or .mp4, .webm, .mkv
    int width = 1280;              ///< px, 16..16384
    int height = 720;              ///< px
    bool transparent = false;      ///< else over `background`; videos never are
    bool withValues = false;       ///< also light, id, depth, normal, motion and texture, beside the pictures
    bool resume = false;           ///< keep pictures that are there and finished
    glm::vec3 background{0};       ///< display-referred RGB
};

/// What is written of an animation, and where: values go into "name values" beside name.####.png.
project::AnimationOutput outputOf(const project::Animation& animation, const AnimationSettings& settings);

/// Paints the frames of the project's render range by its method, as `chiaro animate` does, and writes them.
/// Cancelled or failing amid it, pictures that are finished stay and no video does. Returns how many were
/// finished before. Throws Error, Cancelled.
int exportAnimation(const project::Project& project, const scene::Scene& scene,
                    const AnimationSettings& settings, const Task& task);

}  // namespace chiaro::app
