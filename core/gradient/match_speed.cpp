#include "core/gradient/gradient.h"
#include "core/gradient/speed_curve.h"

#include <algorithm>
#include <limits>

namespace chiaro::gradient {

namespace {

/// A curve is compared with the averages at so many places along the strip.
constexpr int comparedPlaces = 384;
/// Levels of u among which the warping chooses; refined afterwards.
constexpr int coarseLevels = 65;
/// A curve twice as steep as the identity costs as much as colours that are off by this part of their spread.
/// Without such a cost the curve follows single strokes, and the gradient shows them as bands.
constexpr double stiffness = 0.06;
/// Control points are left out while the fit gets no worse than this.
constexpr double simplification = 1.02;

/// The colours averaged over the neighbourhood of `count` evenly spread places.
Gradient thinned(const Gradient& colors, int count) {
    Gradient result;
    const double last = double(colors.size() - 1);
    for (int i = 0; i < count; ++i) {
        const auto edge = [&](double place) { return std::clamp(place / (count - 1) * last, 0.0, last); };
        const auto begin = std::size_t(std::lround(edge(i - 0.5)));
        const auto end = std::max(begin + 1, std::size_t(std::lround(edge(i + 0.5))));
        glm::dvec3 sum(0);
        for (std::size_t column = begin; column < end; ++column) sum += glm::dvec3(colors[column]);
        result.push_back(glm::vec3(sum / double(end - begin)));
    }
    return result;
}

double meanSquaredSpread(const Gradient& colors) {
    glm::dvec3 sum(0), squares(0);
    for (const glm::vec3& color : colors) {
        sum += glm::dvec3(color);
        squares += glm::dvec3(color) * glm::dvec3(color);
    }
    const glm::dvec3 mean = sum / double(colors.size());
    const glm::dvec3 variance = squares / double(colors.size()) - mean * mean;
    return std::max(0.0, variance.r + variance.g + variance.b);
}

/// What a speed curve costs: the mean squared distance of G(u(x)) from the averages, and its stiffness.
class Fit {
public:
    Fit(const Gradient& gradient, const Gradient& averages)
        : m_gradient(gradient),
          m_averages(thinned(averages, std::min(comparedPlaces, int(averages.size())))),
          m_stiffness(stiffness * stiffness * meanSquaredSpread(averages)) {}

    /// Per interval between places.
    double bend(double rise, double run) const {
        const double excess = rise / run - 1;
        return m_stiffness * excess * excess * run;
    }

    /// The cost of the places with x in [xLow, xHigh) while u rises evenly from `low` to `high`.
    double segment(double xLow, double xHigh, double low, double high) const {
        const double last = double(m_averages.size() - 1);
        double sum = 0;
        for (auto i = std::size_t(std::ceil(xLow * last)); double(i) < xHigh * last; ++i)
            sum += distance(i, low + (high - low) * (double(i) / last - xLow) / (xHigh - xLow));
        return sum / double(m_averages.size()) + bend(high - low, xHigh - xLow);
    }

    double operator()(const SpeedCurve& curve) const {
        const std::vector<double> pace = curve.sampled(int(m_averages.size()));
        const double run = 1.0 / double(pace.size() - 1);
        double distances = 0, bends = 0;
        for (std::size_t i = 0; i < pace.size(); ++i) {
            distances += distance(i, pace[i]);
            if (i > 0) bends += bend(pace[i] - pace[i - 1], run);
        }
        return distances / double(pace.size()) + bends;
    }

private:
    double distance(std::size_t place, double u) const {
        const glm::dvec3 difference = glm::dvec3(lookUp(m_gradient, u)) - glm::dvec3(m_averages[place]);
        return glm::dot(difference, difference);
    }

    const Gradient& m_gradient;
    Gradient m_averages;
    double m_stiffness;
};

/// Dynamic time warping: the levels at evenly spaced knots, never falling, from 0 to 1, that cost least when
/// u is linear between them.
SpeedCurve warped(const Fit& fit, int knots) {
    const auto level = [](int i) { return double(i) / (coarseLevels - 1); };
    const auto place = [&](int knot) { return double(knot) / (knots - 1); };
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> costs(coarseLevels, never);
    costs.front() = 0;
    std::vector<std::vector<int>> cameFrom;
    for (int knot = 1; knot < knots; ++knot) {
        std::vector<double> next(coarseLevels, never);
        std::vector<int>& from = cameFrom.emplace_back(coarseLevels, 0);
        for (int low = 0; low < coarseLevels; ++low) {
            if (costs[std::size_t(low)] == never) continue;
            for (int high = low; high < coarseLevels; ++high) {
                const double cost = costs[std::size_t(low)] +
                                    fit.segment(place(knot - 1), place(knot), level(low), level(high));
                if (cost >= next[std::size_t(high)]) continue;
                next[std::size_t(high)] = cost;
                from[std::size_t(high)] = low;
            }
        }
        costs = std::move(next);
    }
    SpeedCurve curve;
    curve.points.assign(std::size_t(knots), {1, 1});
    int high = coarseLevels - 1;
    for (int knot = knots - 1; knot > 0; --knot) {
        high = cameFrom[std::size_t(knot - 1)][std::size_t(high)];
        curve.points[std::size_t(knot - 1)] = {float(place(knot - 1)), float(level(high))};
    }
    return curve;
}

/// Moves one control point at a time up and down, by ever smaller steps, as long as that costs less.
void refine(const Fit& fit, SpeedCurve& curve) {
    double best = fit(curve);
    for (float step = 0.5f / (coarseLevels - 1); step > 1e-3f; step /= 2) {
        for (std::size_t i = 1; i + 1 < curve.points.size(); ++i) {
            for (const float change : {-step, step}) {
                const float before = curve.points[i].y;
                curve.points[i].y = std::clamp(before + change, curve.points[i - 1].y, curve.points[i + 1].y);
                if (const double cost = fit(curve); cost < best)
                    best = cost;
                else
                    curve.points[i].y = before;
            }
        }
    }
}

/// Leaves out the point that matters least, again and again, while the cost stays below the limit.
void simplify(const Fit& fit, SpeedCurve& curve) {
    const double limit = fit(curve) * simplification;
    while (curve.points.size() > 2) {
        double leastCost = std::numeric_limits<double>::infinity();
        SpeedCurve simplest;
        for (std::size_t i = 1; i + 1 < curve.points.size(); ++i) {
            SpeedCurve without = curve;
            without.points.erase(without.points.begin() + std::ptrdiff_t(i));
            const double cost = fit(without);
            if (cost >= leastCost) continue;
            leastCost = cost;
            simplest = std::move(without);
        }
        if (leastCost > limit) return;
        curve = std::move(simplest);
    }
}

double squaredResidue(const Gradient& gradient, const Gradient& averages, const SpeedCurve& curve) {
    const Gradient followed = atSpeed(gradient, curve);
    double sum = 0;
    for (std::size_t i = 0; i < averages.size(); ++i) {
        const glm::dvec3 difference = glm::dvec3(followed[i]) - glm::dvec3(averages[i]);
        sum += glm::dot(difference, difference);
    }
    return sum;
}

}  // namespace

SpeedCurve matchSpeed(const Gradient& gradient, const Gradient& averages, int maximumPoints) {
    if (averages.size() < 3 || maximumPoints < 3) return {};
    const Fit fit(gradient, averages);
    SpeedCurve curve = warped(fit, maximumPoints);
    refine(fit, curve);
    simplify(fit, curve);
    refine(fit, curve);
    const bool better = squaredResidue(gradient, averages, curve) < squaredResidue(gradient, averages, {});
    return better ? curve : SpeedCurve{};
}

}  // namespace chiaro::gradient
