#pragma once

#include "core/export/atlas.h"
#include "core/export/textured_mesh.h"
#include "core/project/pipeline.h"

namespace chiaro::project {

/// How a painted mesh is written.
struct MeshExportParams {
    int atlas = 2048;  ///< the texture's side, 64..8192 texels
    int padding = 8;   ///< between its charts, 0..64 texels
    exporting::Bake bake = exporting::Bake::Lit;
    bool dilate = true;  ///< let charts grow until they meet
    static const ParameterTable<MeshExportParams>& table();
    friend bool operator==(const MeshExportParams&, const MeshExportParams&) = default;
};

/// A painted mesh, and how well its atlas does its work.
struct ExportedMesh {
    exporting::TexturedScene scene;
    exporting::AtlasReport report;  ///< only `faces` for a format without a texture
    double atlasSeconds = 0;
    double bakeSeconds = 0;
};

/// Paints the visible objects of a scene for a mesh file. View-dependent textures are evaluated on the
/// surface; the other methods paint a picture of each view of the objects' plans, and each place shows the
/// one that faces it best, or a blend of two. `worn` as from wornPaints(). Deterministic for any number of
/// threads. Throws Error when no object is visible or the atlas is too small, Cancelled.
ExportedMesh paintMesh(const Project& project, const scene::Scene& scene, const WornPaints& worn,
                       exporting::MeshFormat format, const MeshExportParams& params, const Task& task = {});

}  // namespace chiaro::project
