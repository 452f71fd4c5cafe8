#include "core/gradient/speed_curve.h"

#include "core/base/error.h"

#include <boost/math/interpolators/cubic_hermite.hpp>

#include <algorithm>

namespace chiaro::gradient {

namespace {

void check(const std::vector<glm::vec2>& points) {
    const auto refuse = [](const char* problem) {
        return Error("speed curve", problem, "it rises from (0, 0) to (1, 1) without turning back");
    };
    if (points.size() < 2 || points.front() != glm::vec2(0) || points.back() != glm::vec2(1))
        throw refuse("does not go from (0, 0) to (1, 1)");
    for (std::size_t i = 1; i < points.size(); ++i) {
        // Written so that NaN fails too.
        if (!(points[i].x > points[i - 1].x))
            throw refuse("has two points at the same place or out of order");
        if (!(points[i].y >= points[i - 1].y)) throw refuse("falls");
    }
}

/// Slopes that keep a cubic through the points monotone (Fritsch and Butland 1984): at an inner point the
/// weighted harmonic mean of both sides, or 0 beside a level side; at the ends the side's own.
std::vector<double> monotoneSlopes(const std::vector<double>& x, const std::vector<double>& y) {
    const auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
    const std::size_t last = x.size() - 1;
    std::vector<double> slopes(x.size(), 0);
    slopes.front() = secant(0);
    slopes.back() = secant(last - 1);
    for (std::size_t i = 1; i < last; ++i) {
        const double before = x[i] - x[i - 1], after = x[i + 1] - x[i];
        const double left = secant(i - 1), right = secant(i);
        if (left <= 0 || right <= 0) continue;
        const double weightLeft = 2 * after + before, weightRight = after + 2 * before;
        slopes[i] = (weightLeft + weightRight) / (weightLeft / left + weightRight / right);
    }
    return slopes;
}

/// Boost's own pchip starts at four points and doesn't compile beside GLM; its Hermite spline takes any.
auto interpolant(const std::vector<glm::vec2>& points) {
    std::vector<double> x, y;
    for (const glm::vec2& point : points) {
        x.push_back(point.x);
        y.push_back(point.y);
    }
    std::vector<double> slopes = monotoneSlopes(x, y);
    return boost::math::interpolators::cubic_hermite(std::move(x), std::move(y), std::move(slopes));
}

}  // namespace

std::vector<double> SpeedCurve::sampled(int count) const {
    check(points);
    const auto curve = interpolant(points);
    std::vector<double> values(std::size_t(std::max(count, 0)));
    double highest = 0;
    for (int i = 0; i < count; ++i) {
        const double x = count > 1 ? double(i) / double(count - 1) : 0;
        // Rounding must not make it fall or leave [0, 1].
        highest = std::max(highest, std::min(curve(x), 1.0));
        values[std::size_t(i)] = highest;
    }
    if (count > 1) values.back() = 1;
    return values;
}

}  // namespace chiaro::gradient
