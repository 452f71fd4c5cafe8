#pragma once

#include "core/methods/difference_texels.h"
#include "core/methods/view_dependent.h"

#include <glm/gtc/type_precision.hpp>

#include <vector>

namespace chiaro::methods {

/// An object with textures of its own (§4.3) as shaders/view_dependent/ reads it. Points are in object space,
/// less `middle`.
struct ObjectTexels {
    struct Layout {
        glm::dvec3 middle{0};
        glm::ivec3 size{
            0};  ///< of the 3D texture: a page's width and height, levels x pages; 0 without faces
        int levelCount = 0;
        int pageCount = 0;  ///< a page's levels follow each other
        DifferenceRange range;
        double texelSize = 0;        ///< of the finest map before it was reduced, units of the object
        bool isPerspective = false;  ///< some divisor in `views` isn't 1
    };
    Layout layout;
    std::vector<DifferenceTexel> texels;  ///< layer after layer, row after row, top first
    std::vector<glm::vec3> corners;       ///< three a face
    std::vector<glm::uvec2> faceViews;    ///< one a face: its first entry in `weights`, and their number
    std::vector<glm::u16vec4> weights;    ///< view, and its weights at the three corners; ratios matter
    std::vector<glm::vec4> views;  ///< four a view: what (point, 1) is multiplied with for s, t and the
                                   ///< divisor of both; its direction, and the r of its page

    std::size_t textureBytes() const { return texels.size() * sizeof(DifferenceTexel); }
};

/// `largestSide` is that of the 3D texture, `byteLimit` its size: larger maps are shown reduced to a half, a
/// quarter and so on. Safe from any thread.
ObjectTexels objectTexels(const PaintedObject& object, int largestSide,
                          std::size_t byteLimit = std::size_t(512) << 20);

}  // namespace chiaro::methods
