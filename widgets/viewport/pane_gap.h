#pragma once

#include <glm/vec3.hpp>

namespace chiaro::widgets {

/// What is between pictures that lie beside each other: darker than their background, so that they stand
/// apart.
inline glm::vec3 gapColor(glm::vec3 background) {
    return background * 0.5f;
}

}  // namespace chiaro::widgets
