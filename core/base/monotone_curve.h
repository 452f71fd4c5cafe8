#pragma once

#include <functional>
#include <vector>

namespace chiaro {

/// A smooth curve through points that never overshoots them: between two it goes from the one to the other
/// without turning back (cubic; Fritsch and Butland 1984).
class MonotoneCurve {
public:
    enum class Ends {
        Straight,  ///< begins and ends with the slope of the first and last stretch
        Resting    ///< begins and ends level
    };
    /// x strictly rising, y of the same length, at least two.
    MonotoneCurve(std::vector<double> x, std::vector<double> y, Ends ends);

    /// The value at x, which lies between the first and the last.
    double operator()(double x) const { return m_spline(x); }

private:
    std::function<double(double)> m_spline;
};

}  // namespace chiaro
