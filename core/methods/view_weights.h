#pragma once

#include "core/methods/view_textures.h"

#include <array>
#include <span>

namespace chiaro::methods {

/// How an object's faces are painted from its views (§4.3.4 and 6): for each face the groups that it belongs
/// to, and at its corners the place in each group's map and the weight of its texture. Weights are max(n.v,
/// epsilon) with the corner's own normal, and fall to nearly nothing at the border of a group, over some way
/// along the surface, so that no border shows. Immutable.
class ViewWeights {
public:
    struct Corner {
        glm::vec2 position;  ///< in the group's map, texels
        float weight;        ///< > 0; only ratios matter
    };
    struct FaceView {
        std::uint32_t group;
        std::array<Corner, 3> corners;
    };

    /// `epsilon` is the smallest n.v that counts, as the plan was made with.
    ViewWeights(const PlannedObject& object, double epsilon);

    /// The groups of a face; none for a face without area.
    std::span<const FaceView> of(std::uint32_t face) const {
        return {m_views.data() + m_first[face], m_first[face + 1] - m_first[face]};
    }

private:
    std::vector<std::size_t> m_first;
    std::vector<FaceView> m_views;
};

}  // namespace chiaro::methods
