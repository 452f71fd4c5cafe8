#include "tests/core/views/brute_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace chiaro::test {

namespace {

using views::Drawn;
using views::FaceGroup;
using views::Surface;

/// A face in the map of a view: corners x right, y down, in texels; z is the depth.
struct Flat {
    std::array<glm::dvec3, 3> corners;
    double facing = -1;
    bool drawn = false;

    /// Barycentric weights of a point, or NaN.
    glm::dvec3 weights(glm::dvec2 p) const {
        const glm::dvec2 a(corners[0]);
        const glm::dvec2 ab = glm::dvec2(corners[1]) - a;
        const glm::dvec2 ac = glm::dvec2(corners[2]) - a;
        const double area = ab.x * ac.y - ab.y * ac.x;
        const double v = ((p - a).x * ac.y - (p - a).y * ac.x) / area;
        const double w = (ab.x * (p - a).y - ab.y * (p - a).x) / area;
        return {1 - v - w, v, w};
    }
    double depth(glm::dvec3 weights) const {
        return weights.x * corners[0].z + weights.y * corners[1].z + weights.z * corners[2].z;
    }
};

double smallest(glm::dvec3 weights) {
    return std::min({weights.x, weights.y, weights.z});
}

/// One group, every face of the mesh flattened by its matrices.
class GroupCheck {
public:
    GroupCheck(const Surface& surface, const FaceGroup& group, const std::vector<int>& firstPass,
               double epsilon)
        : m_surface(surface),
          m_group(group),
          m_epsilon(epsilon),
          m_size(group.view.size),
          m_flat(surface.faceCount()) {
        const glm::dmat4 view = group.view.viewMatrix();
        const glm::dmat4 both = group.view.projectionMatrix() * view;
        // The last row of the inverse view matrix's rotation is the way to the eye of an orthographic view.
        const glm::dvec3 back(view[0][2], view[1][2], view[2][2]);
        for (std::uint32_t face = 0; face < m_flat.size(); ++face) {
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec4 clip = both * glm::dvec4(surface.corner(face, k), 1);
                m_flat[face].corners[k] = {(clip.x / clip.w + 1) / 2 * m_size,
                                           (1 - clip.y / clip.w) / 2 * m_size,
                                           -(view * glm::dvec4(surface.corner(face, k), 1)).z};
            }
            if (surface.area(face) > 0) m_flat[face].facing = glm::dot(surface.normal(face), back);
            m_flat[face].drawn = surface.area(face) > 0 && isDrawn(face, firstPass[face]);
        }
    }

    void run() const {
        std::vector<bool> member(m_flat.size());
        for (const std::uint32_t face : m_group.faces) member[face] = true;
        for (std::uint32_t face = 0; face < m_flat.size(); ++face) {
            const bool facing = m_flat[face].facing > m_epsilon;
            if (member[face]) {
                EXPECT_TRUE(facing) << "face " << face << " turns away";
                EXPECT_FALSE(hiddenAtTexels(face, 1e-9, 2) || hiddenAtCentroid(face, 4))
                    << "face " << face << " of " << m_group.view.name << " is hidden";
            } else if (facing && m_flat[face].drawn && m_group.drawn == Drawn::All && coversTexels(face)) {
                EXPECT_TRUE(hiddenAtTexels(face, -1e-2, 0.5))
                    << "face " << face << " is missing from " << m_group.view.name;
            }
        }
    }

private:
    bool isDrawn(std::uint32_t face, int firstPass) const {
        switch (m_group.drawn) {
            case Drawn::All:
                return true;
            case Drawn::Uncovered:
                return firstPass >= m_group.pass;
            case Drawn::UncoveredFronts:
                return firstPass >= m_group.pass && m_flat[face].facing > m_epsilon;
            case Drawn::EachAlone:
                return false;
        }
        return true;
    }

    /// How much nearer another face must be, times a factor that leaves room for rounding.
    double slack(std::uint32_t face, double factor) const {
        const double facing = m_flat[face].facing;
        return factor * (m_surface.coincidence() + 2e-4 / m_group.view.texelsPerUnit()) / facing;
    }

    template <class Visit>
    bool anyTexel(std::uint32_t face, Visit visit) const {
        const auto& c = m_flat[face].corners;
        const auto [left, right] = std::minmax({c[0].x, c[1].x, c[2].x});
        const auto [top, bottom] = std::minmax({c[0].y, c[1].y, c[2].y});
        for (int y = std::max(0, int(top) - 1); y < std::min(m_size, int(bottom) + 2); ++y)
            for (int x = std::max(0, int(left) - 1); x < std::min(m_size, int(right) + 2); ++x)
                if (visit(glm::dvec2(x + 0.5, y + 0.5))) return true;
        return false;
    }

    bool coversTexels(std::uint32_t face) const {
        return anyTexel(face, [&](glm::dvec2 p) { return smallest(m_flat[face].weights(p)) > 1e-6; });
    }

    /// Whether another face lies in front at a texel centre that both cover, each edge moved outwards by
    /// -inside.
    bool hiddenAtTexels(std::uint32_t face, double inside, double factor) const {
        return anyTexel(face, [&](glm::dvec2 p) {
            const glm::dvec3 weights = m_flat[face].weights(p);
            return smallest(weights) > inside &&
                   hiddenAt(face, p, m_flat[face].depth(weights) - slack(face, factor), inside);
        });
    }

    bool hiddenAtCentroid(std::uint32_t face, double factor) const {
        if (coversTexels(face)) return false;
        const auto& c = m_flat[face].corners;
        const glm::dvec3 middle = (c[0] + c[1] + c[2]) / 3.0;
        return hiddenAt(face, glm::dvec2(middle), middle.z - slack(face, factor), 1e-6);
    }

    bool hiddenAt(std::uint32_t face, glm::dvec2 p, double nearer, double inside) const {
        for (std::uint32_t other = 0; other < m_flat.size(); ++other) {
            if (!m_flat[other].drawn || m_surface.adjacent(face, other)) continue;
            const glm::dvec3 weights = m_flat[other].weights(p);
            if (smallest(weights) > inside && m_flat[other].depth(weights) < nearer) return true;
        }
        return false;
    }

    const Surface& m_surface;
    const FaceGroup& m_group;
    double m_epsilon;
    int m_size;
    std::vector<Flat> m_flat;
};

}  // namespace

void expectRightGroups(const Surface& surface, const views::ViewPlan& plan, const views::ViewParams& params) {
    std::vector<int> firstPass(surface.faceCount(), std::numeric_limits<int>::max());
    for (const FaceGroup& group : plan.groups)
        for (const std::uint32_t face : group.faces) firstPass[face] = std::min(firstPass[face], group.pass);
    for (std::uint32_t face = 0; face < firstPass.size(); ++face) {
        const bool covered = firstPass[face] < std::numeric_limits<int>::max();
        EXPECT_EQ(covered, surface.area(face) > 0) << "face " << face;
        EXPECT_EQ(!covered, std::ranges::binary_search(plan.unreachable, face)) << "face " << face;
    }
    for (const FaceGroup& group : plan.groups) {
        EXPECT_TRUE(std::ranges::is_sorted(group.faces));
        for (const std::uint32_t face : group.faces)
            EXPECT_EQ(firstPass[face], group.pass) << "face " << face << " was covered before";
        GroupCheck(surface, group, firstPass, params.epsilon).run();
    }
}

}  // namespace chiaro::test
