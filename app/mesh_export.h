#pragma once

#include "app/picture_export.h"
#include "core/project/mesh_export.h"

namespace chiaro::app {

/// What the artist chose for a mesh file.
struct MeshSettings {
    std::filesystem::path path;  ///< its extension decides the format
    project::MeshExportParams params;
};

/// Paints the mesh by core and by the project's method and writes its files, replacing what is there. Throws
/// Error, Cancelled.
exporting::AtlasReport exportMesh(const PictureSource& source, const MeshSettings& settings,
                                  const Task& task);

}  // namespace chiaro::app
