#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace chiaro::exporting {

/// Finds the texels of an atlas that one face covers.
class TexelScan {
public:
    /// `corners` in texels. Empty for a face that has no area there.
    static std::optional<TexelScan> of(const std::array<glm::vec2, 3>& corners) {
        TexelScan scan;
        scan.m_origin = glm::dvec2(corners[0]);
        scan.m_sides = {glm::dvec2(corners[1]) - scan.m_origin, glm::dvec2(corners[2]) - scan.m_origin};
        const double area = glm::determinant(scan.m_sides);
        if (area == 0 || !std::isfinite(1 / area)) return {};
        scan.m_toBarycentrics = glm::inverse(scan.m_sides);
        const glm::vec2 low = glm::min(glm::min(corners[0], corners[1]), corners[2]);
        const glm::vec2 high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
        scan.m_low = glm::ivec2(glm::floor(low));
        scan.m_high = glm::ivec2(glm::floor(high)) + 1;
        return scan;
    }

    /// The texels of its box, from low up to but without high.
    glm::ivec2 low() const { return m_low; }
    glm::ivec2 high() const { return m_high; }

    /// Calls visit(texel, barycentrics) for each texel whose centre the face covers, its border included;
    /// only in the rows from rows.x up to but without rows.y.
    template <class Visit>
    void scan(glm::ivec2 rows, Visit visit) const {
        for (int y = std::max(m_low.y, rows.x); y < std::min(m_high.y, rows.y); ++y) {
            const glm::dvec2 first = barycentricsAt({m_low.x + 0.5, y + 0.5});
            for (int x = m_low.x; x < m_high.x; ++x) {
                const glm::dvec2 place = first + m_toBarycentrics[0] * double(x - m_low.x);
                if (isInside(place)) visit(glm::ivec2(x, y), glm::vec2(place));
            }
        }
    }

    static bool isInside(const glm::dvec2& barycentrics) {
        return barycentrics.x >= 0 && barycentrics.y >= 0 && barycentrics.x + barycentrics.y <= 1;
    }
    /// Weights of the second and third corner at a place, texels.
    glm::dvec2 barycentricsAt(const glm::dvec2& place) const { return m_toBarycentrics * (place - m_origin); }

    /// How far a place lies from the nearest edge, texels; positive inside.
    double distanceToBorder(const glm::dvec2& barycentrics) const {
        const double area = std::abs(glm::determinant(m_sides));
        const double across = area / glm::length(m_sides[1] - m_sides[0]);
        return std::min({barycentrics.x * area / glm::length(m_sides[1]),
                         barycentrics.y * area / glm::length(m_sides[0]),
                         (1 - barycentrics.x - barycentrics.y) * across});
    }

private:
    glm::dvec2 m_origin{0};
    glm::dmat2 m_sides{1};
    glm::dmat2 m_toBarycentrics{1};
    glm::ivec2 m_low{0};
    glm::ivec2 m_high{0};
};

}  // namespace chiaro::exporting
