#include "core/base/monotone_curve.h"

#include <boost/math/interpolators/cubic_hermite.hpp>

namespace chiaro {

namespace {

/// At an inner point the weighted harmonic mean of the slopes on both sides, or 0 where the curve turns.
std::vector<double> monotoneSlopes(const std::vector<double>& x, const std::vector<double>& y,
                                   MonotoneCurve::Ends ends) {
    const auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
    const std::size_t last = x.size() - 1;
    std::vector<double> slopes(x.size(), 0);
    if (ends == MonotoneCurve::Ends::Straight) {
        slopes.front() = secant(0);
        slopes.back() = secant(last - 1);
    }
    for (std::size_t i = 1; i < last; ++i) {
        const double before = x[i] - x[i - 1], after = x[i + 1] - x[i];
        const double left = secant(i - 1), right = secant(i);
        if (left * right <= 0) continue;
        const double weightLeft = 2 * after + before, weightRight = after + 2 * before;
        slopes[i] = (weightLeft + weightRight) / (weightLeft / left + weightRight / right);
    }
    return slopes;
}

}  // namespace

MonotoneCurve::MonotoneCurve(std::vector<double> x, std::vector<double> y, Ends ends) {
    std::vector<double> slopes = monotoneSlopes(x, y, ends);
    // Boost's own pchip starts at four points and doesn't compile beside GLM; its Hermite spline takes any.
    m_spline = boost::math::interpolators::cubic_hermite(std::move(x), std::move(y), std::move(slopes));
}

}  // namespace chiaro
