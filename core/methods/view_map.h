#pragma once

#include "core/methods/view_textures.h"
#include "core/views/correspondence.h"
#include "core/views/group_map.h"

#include <optional>
#include <span>
#include <unordered_map>

namespace chiaro::methods {

/// The groups that each face of an object belongs to, and how directly it faces each view.
class FaceGroups {
public:
    struct Membership {
        std::uint32_t group;
        float facing;  ///< n.v of the face, (0, 1]
    };
    explicit FaceGroups(const PlannedObject& object);
    std::span<const Membership> of(std::uint32_t face) const {
        return {m_memberships.data() + m_first[face], m_first[face + 1] - m_first[face]};
    }

private:
    std::vector<std::size_t> m_first;
    std::vector<Membership> m_memberships;
};

/// The part of a view's map that its group covers and a margin around it: which face each texel shows.
struct ViewMap {
    static constexpr int margin = 4;  ///< texels
    glm::ivec2 origin{0};             ///< of the top left texel in the map
    Image<std::uint32_t> face;        ///< in the margin the nearest one; views::noFace beyond
    synthesis::PixelMask covered;     ///< not 0 where there is a face, the margin's included

    static ViewMap of(const PlannedObject& object, std::size_t group);
    /// Whether there is texture all around a position in the map, to be read between texels.
    bool covers(glm::vec2 position) const;
    glm::vec2 center(int x, int y) const { return glm::vec2(origin + glm::ivec2(x, y)) + 0.5f; }
};

/// The affine maps from one view's map to another's, one for each face that both paint.
class ViewMapping {
public:
    ViewMapping(const PlannedObject& object, std::size_t from, std::size_t to);
    /// Where a position in the one map lies in the other; empty where the face isn't shared or is edge-on.
    std::optional<glm::vec2> map(std::uint32_t face, glm::vec2 position) const;

private:
    std::unordered_map<std::uint32_t, views::AffineMap> m_maps;
};

}  // namespace chiaro::methods
