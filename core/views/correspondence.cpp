#include "core/views/correspondence.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace chiaro::views {

std::vector<std::uint32_t> sharedFaces(const FaceGroup& a, const FaceGroup& b) {
    std::vector<std::uint32_t> shared;
    std::ranges::set_intersection(a.faces, b.faces, std::back_inserter(shared));
    return shared;
}

std::optional<AffineMap> triangleMap(const Surface& surface, std::uint32_t face, const Projector& from,
                                     const Projector& to) {
    std::array<glm::dvec2, 3> source;
    std::array<glm::dvec2, 3> target;
    for (std::size_t k = 0; k < 3; ++k) {
        source[k] = glm::dvec2(from.project(surface.corner(face, k)));
        target[k] = glm::dvec2(to.project(surface.corner(face, k)));
    }
    const glm::dmat2 sides(source[1] - source[0], source[2] - source[0]);
    const double longest =
        std::max({glm::dot(sides[0], sides[0]), glm::dot(sides[1], sides[1]),
                  glm::distance(source[1], source[2]) * glm::distance(source[1], source[2])});
    // A triangle a million times as long as it is high: what rounding leaves of its height is no map.
    if (!(std::abs(glm::determinant(sides)) > 1e-6 * longest)) return {};
    AffineMap map;
    map.linear = glm::dmat2(target[1] - target[0], target[2] - target[0]) * glm::inverse(sides);
    map.offset = target[0] - map.linear * source[0];
    return map;
}

}  // namespace chiaro::views
