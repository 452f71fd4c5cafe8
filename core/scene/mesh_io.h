#pragma once

#include "core/base/task.h"
#include "core/scene/mesh.h"

#include <filesystem>
#include <vector>

namespace chiaro::scene {

/// What a file held, and what of it is unusual enough to tell the artist.
struct Model {
    std::vector<Mesh> meshes;          ///< the file's objects, in its order, each with a name of its own
    std::size_t faces = 0;             ///< triangles in all
    std::size_t degenerateFaces = 0;   ///< kept, but without area
    std::size_t nonManifoldEdges = 0;  ///< edges of more than two faces
    std::size_t boundaryEdges = 0;
    std::vector<std::string> warnings;  ///< a sentence each
};

/// Reads OBJ, PLY (ascii and both binary orders), OFF, STL, GLB or glTF; the content decides where it can,
/// else the extension. Polygons are triangulated as fans, so triangles keep the file's face order; node
/// transforms are applied; missing normals are computed. Throws Error naming the file when it is missing,
/// damaged, has no faces, has indices out of range or vertices that are not finite, or more than 20 million
/// triangles; Cancelled when the task was.
Model readModel(const std::filesystem::path& path, const Task& task = {});

}  // namespace chiaro::scene
