#pragma once

#include "core/scene/mesh.h"

namespace chiaro::scene {

/// The triangles wound so that their front is the side that their normals point to, as the light decides: a
/// file's winding may say otherwise. Those that are turned have their second and third corner swapped.
std::vector<Triangle> trianglesTowardsNormals(const Mesh& mesh);

}  // namespace chiaro::scene
