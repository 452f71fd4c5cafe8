#pragma once

#include "core/scene/mesh.h"

#include <glm/glm.hpp>

namespace chiaro::scene {

/// How an object stands in the scene, from where its file puts it: scaled and turned about its own centre,
/// then moved.
struct Placement {
    glm::vec3 position{0};  ///< how far it is moved, world units
    glm::vec3 rotation{0};  ///< degrees around x, then y, then z, any number of turns
    glm::vec3 scale{1};     ///< along its axes; negative mirrors; not 0
    friend bool operator==(const Placement&, const Placement&) = default;

    /// From the file's place to the scene; `centre` is the object's, where the file puts it.
    glm::mat4 matrix(glm::vec3 centre) const;
};

/// The middle of the box around all vertices: the centre about which an object is placed. Quick enough to be
/// asked for amid a drag; boundsOf() is not.
glm::vec3 centreOf(const Mesh& mesh);

}  // namespace chiaro::scene
