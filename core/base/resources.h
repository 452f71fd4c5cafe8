#pragma once

#include <filesystem>

namespace chiaro {

/// The folder that holds the demo's samples, meshes and project: $CHIARO_RESOURCES when set, else
/// ../share/chiaro beside the program when it is installed, else the source tree's. Throws Error when none is
/// there.
std::filesystem::path resourceFolder();

/// The program of relightable pages, which the build makes: page/relightable.html in $CHIARO_RESOURCES if it is
/// there, else in ../share/chiaro beside the program, where it may be missing.
std::filesystem::path pageFile();

}  // namespace chiaro
