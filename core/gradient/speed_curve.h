#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace chiaro::gradient {

/// How fast the gradient's colours pass along the strip (§3.1): a monotone map u(x) of [0, 1] onto itself,
/// through the artist's control points by monotone cubic interpolation.
struct SpeedCurve {
    /// In order of x, strictly rising in x and not falling in y; the first at (0, 0) and the last at (1, 1).
    std::vector<glm::vec2> points{{0, 0}, {1, 1}};
    friend bool operator==(const SpeedCurve&, const SpeedCurve&) = default;

    /// `count` values u(i / (count - 1)), each in [0, 1], never falling. Throws Error when the points break
    /// the rules above.
    std::vector<double> sampled(int count) const;
};

/// The curve whose G(u(x)) follows the column averages best, found by dynamic time warping and reduced to at
/// most `maximumPoints` control points, so that the artist can go on from it. `gradient` and `averages` have
/// W colours each.
SpeedCurve matchSpeed(const std::vector<glm::vec3>& gradient, const std::vector<glm::vec3>& averages,
                      int maximumPoints = 24);

}  // namespace chiaro::gradient
