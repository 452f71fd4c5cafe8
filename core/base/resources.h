#pragma once

#include <filesystem>

namespace chiaro {

/// The folder that holds the demo's samples, meshes and project: $CHIARO_RESOURCES when set, else
/// ../share/chiaro beside the program when it is installed, else the source tree's. Throws Error when none is
/// there.
std::filesystem::path resourceFolder();

}  // namespace chiaro
