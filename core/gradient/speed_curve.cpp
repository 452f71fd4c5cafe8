#include "core/gradient/speed_curve.h"

#include "core/base/error.h"
#include "core/base/monotone_curve.h"

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

}  // namespace

std::vector<double> SpeedCurve::sampled(int count) const {
    check(points);
    std::vector<double> x, y;
    for (const glm::vec2& point : points) {
        x.push_back(double(point.x));
        y.push_back(double(point.y));
    }
    const MonotoneCurve curve(std::move(x), std::move(y), MonotoneCurve::Ends::Straight);
    std::vector<double> values(std::size_t(std::max(count, 0)));
    double highest = 0;
    for (int i = 0; i < count; ++i) {
        const double place = count > 1 ? double(i) / double(count - 1) : 0;
        // Rounding must not make it fall or leave [0, 1].
        highest = std::max(highest, std::min(curve(place), 1.0));
        values[std::size_t(i)] = highest;
    }
    if (count > 1) values.back() = 1;
    return values;
}

}  // namespace chiaro::gradient
