#pragma once

#include "core/base/task.h"
#include "core/scene/mesh.h"

namespace chiaro::scene {

// The functions of mesh.h that take a while for a large mesh, as they can be cancelled: the same, but they
// throw Cancelled.

std::vector<glm::vec3> angleWeightedNormals(const Mesh& mesh, const Task& task);
Mesh splitAtCreases(const Mesh& mesh, float creaseDegrees, const Task& task);
Topology topologyOf(const Mesh& mesh, const Task& task);

}  // namespace chiaro::scene
