#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace chiaro::methods {

/// Rectangles side by side on pages of one size.
struct TextureAtlas {
    struct Place {
        int page = 0;
        glm::ivec2 origin{0};  ///< of the top left texel
    };
    glm::ivec2 pageSize{0};
    int pageCount = 0;
    std::vector<Place> places;  ///< one a rectangle, in their order

    std::size_t texelCount() const {
        return std::size_t(pageSize.x) * std::size_t(pageSize.y) * std::size_t(pageCount);
    }
};

/// Packs rectangles onto as few texels as rows of them, the tallest first, take. No side is longer than
/// `largestSide`. Empty rectangles take no place.
TextureAtlas packAtlas(const std::vector<glm::ivec2>& sizes, int largestSide);

}  // namespace chiaro::methods
