#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace chiaro::test {

/// The area that two triangles share, by clipping the one at the other's edges; any sense of rotation.
inline double commonArea(const std::array<glm::dvec2, 3>& a, const std::array<glm::dvec2, 3>& b) {
    const auto cross = [](glm::dvec2 u, glm::dvec2 v) { return u.x * v.y - u.y * v.x; };
    std::vector<glm::dvec2> polygon(a.begin(), a.end());
    const double sense = cross(b[1] - b[0], b[2] - b[0]) < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 3 && !polygon.empty(); ++k) {
        const glm::dvec2 from = b[k], edge = b[(k + 1) % 3] - b[k];
        const auto height = [&](glm::dvec2 point) { return sense * cross(edge, point - from); };
        std::vector<glm::dvec2> clipped;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec2 here = polygon[i], next = polygon[(i + 1) % polygon.size()];
            const double h = height(here), n = height(next);
            if (h >= 0) clipped.push_back(here);
            if ((h > 0 && n < 0) || (h < 0 && n > 0)) clipped.push_back(here + (next - here) * (h / (h - n)));
        }
        polygon = std::move(clipped);
    }
    double area = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        area += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]) / 2;
    return std::abs(area);
}

}  // namespace chiaro::test
