#pragma once

#include "core/base/task.h"
#include "core/project/project.h"

#include <filesystem>

namespace chiaro::app {

/// Where a project's animation is written to, and how large.
struct AnimationSettings {
    std::filesystem::path output;  ///< name.####.png (.tif, .exr), #### being the frame; or .mp4, .webm, .mkv
    int width = 1280;              ///< px, 16..16384
    int height = 720;              ///< px
    bool transparent = false;      ///< else over `background`; videos never are
    glm::vec3 background{0};       ///< display-referred RGB
};

/// Paints the frames of the project's render range by its method, as `chiaro animate` does, and writes them.
/// Cancelled or failing amid it, pictures that are finished stay and no video does. Throws Error, Cancelled.
void exportAnimation(const project::Project& project, const scene::Scene& scene,
                     const AnimationSettings& settings, const Task& task);

/// Throws Error when nothing can be written there.
void checkAnimationOutput(const std::filesystem::path& output);

}  // namespace chiaro::app
