#include "core/gradient/gradient.h"
#include "core/gradient/speed_curve.h"

#include <limits>

namespace chiaro::gradient {

namespace {

/// Averages and gradient thinned to what the fit needs; positions are fractions of the strip.
struct Fit {
    const Gradient& gradient;
    const Gradient& averages;
    std::size_t stride;  ///< every so many columns are compared

    double cost(std::size_t column, double u) const {
        const glm::dvec3 difference = glm::dvec3(lookUp(gradient, u)) - glm::dvec3(averages[column]);
        return glm::dot(difference, difference);
    }

    /// Squared differences over the compared columns in [begin, end) while u goes linearly from `low` to
    /// `high` between the two knots.
    double segment(double xLow, double xHigh, double low, double high) const {
        const double last = double(averages.size() - 1);
        double sum = 0;
        const auto begin = std::size_t(std::ceil(xLow * last / double(stride))) * stride;
        for (std::size_t column = begin; column < averages.size() && double(column) / last < xHigh;
             column += stride) {
            const double t = (double(column) / last - xLow) / (xHigh - xLow);
            sum += cost(column, low + (high - low) * t);
        }
        return sum;
    }

    double curve(const SpeedCurve& candidate) const {
        const std::vector<double> pace = candidate.sampled(int(averages.size()));
        double sum = 0;
        for (std::size_t column = 0; column < averages.size(); ++column) sum += cost(column, pace[column]);
        return sum;
    }
};

/// Dynamic time warping between knots: the non-falling levels at evenly spaced knots that cost least.
/// `allowed[k]` are the levels that knot k may take, rising.
std::vector<double> warp(const Fit& fit, const std::vector<std::vector<double>>& allowed, double stiffness) {
    const std::size_t last = allowed.size() - 1;
    std::vector<std::vector<double>> costs(allowed.size());
    std::vector<std::vector<std::size_t>> from(allowed.size());
    costs[0].assign(allowed[0].size(), 0);
    for (std::size_t knot = 1; knot <= last; ++knot) {
        const double xLow = double(knot - 1) / double(last), xHigh = double(knot) / double(last);
        costs[knot].assign(allowed[knot].size(), std::numeric_limits<double>::infinity());
        from[knot].assign(allowed[knot].size(), 0);
        for (std::size_t high = 0; high < allowed[knot].size(); ++high) {
            for (std::size_t low = 0; low < allowed[knot - 1].size(); ++low) {
                const double rise = allowed[knot][high] - allowed[knot - 1][low];
                if (rise < 0) break;
                const double bend = rise * double(last) - 1;
                const double cost = costs[knot - 1][low] + stiffness * bend * bend +
                                    fit.segment(xLow, xHigh, allowed[knot - 1][low], allowed[knot][high]);
                if (cost >= costs[knot][high]) continue;
                costs[knot][high] = cost;
                from[knot][high] = low;
            }
        }
    }
    std::vector<double> levels(allowed.size());
    std::size_t level =
        std::size_t(std::min_element(costs[last].begin(), costs[last].end()) - costs[last].begin());
    for (std::size_t knot = last; knot > 0; --knot) {
        levels[knot] = allowed[knot][level];
        level = from[knot][level];
    }
    levels[0] = allowed[0][level];
    return levels;
}

SpeedCurve curveThrough(const std::vector<double>& levels) {
    SpeedCurve curve;
    curve.points.clear();
    for (std::size_t i = 0; i < levels.size(); ++i)
        curve.points.emplace_back(float(i) / float(levels.size() - 1), float(levels[i]));
    return curve;
}

std::vector<std::vector<double>> coarseLevels(std::size_t knots, int levels) {
    std::vector<double> all;
    for (int i = 0; i < levels; ++i) all.push_back(double(i) / double(levels - 1));
    std::vector<std::vector<double>> allowed(knots, all);
    allowed.front() = {0.0};
    allowed.back() = {1.0};
    return allowed;
}

}  // namespace

SpeedCurve matchSpeed(const std::vector<glm::vec3>& gradient, const std::vector<glm::vec3>& averages,
                      int maximumPoints) {
    constexpr int levels = 65;
    const std::size_t knots = std::size_t(std::max(maximumPoints, 2));
    const Fit fit{gradient, averages, std::max<std::size_t>(1, averages.size() / 384)};
    const SpeedCurve matched = curveThrough(warp(fit, coarseLevels(knots, levels), 0));
    return fit.curve(matched) < fit.curve(SpeedCurve{}) ? matched : SpeedCurve{};
}

}  // namespace chiaro::gradient
