#pragma once

#include <filesystem>
#include <vector>

namespace chiaro::scene {

/// The files that a mesh file names and that lie beside it or below: buffers and pictures of glTF and GLB,
/// materials of an OBJ and their pictures. Relative to its folder, each once; those that aren't there, or
/// lie elsewhere, are left out. A file that can't be read names none: reading it as a mesh tells why.
std::vector<std::filesystem::path> sideFiles(const std::filesystem::path& mesh);

}  // namespace chiaro::scene
