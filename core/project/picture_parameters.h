#pragma once

#include "core/project/project.h"

#include <nlohmann/json_fwd.hpp>

namespace chiaro::project {

/// Method, samples and how they are laid on: what a picture tells of how it was made.
nlohmann::json paintParameters(const Project& project);
/// Meshes, camera and lights.
nlohmann::json sceneParameters(const Project& project);

}  // namespace chiaro::project
