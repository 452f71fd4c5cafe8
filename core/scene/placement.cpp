#include "core/scene/placement.h"

#include <glm/gtc/matrix_transform.hpp>

namespace chiaro::scene {

glm::mat4 Placement::matrix(glm::vec3 centre) const {
    if (*this == Placement{}) return glm::mat4(1);  // no rounding where nothing moves
    const glm::vec3 angles = glm::radians(rotation);
    glm::mat4 matrix = glm::translate(glm::mat4(1), position + centre);
    matrix = glm::rotate(matrix, angles.z, glm::vec3(0, 0, 1));
    matrix = glm::rotate(matrix, angles.y, glm::vec3(0, 1, 0));
    matrix = glm::rotate(matrix, angles.x, glm::vec3(1, 0, 0));
    matrix = glm::scale(matrix, scale);
    return glm::translate(matrix, -centre);
}

glm::vec3 centreOf(const Mesh& mesh) {
    if (mesh.positions.empty()) return glm::vec3(0);
    glm::vec3 low = mesh.positions.front(), high = low;
    for (const glm::vec3& position : mesh.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    return low * 0.5f + high * 0.5f;
}

}  // namespace chiaro::scene
