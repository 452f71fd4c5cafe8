#include "core/gradient/speed_curve.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/gradient/gradient.h"

#include <gtest/gtest.h>

#include <limits>

namespace chiaro::gradient {
namespace {

TEST(SpeedCurve, TwoPointsAreTheIdentity) {
    EXPECT_EQ(SpeedCurve{}.sampled(5), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
    EXPECT_EQ(SpeedCurve{}.sampled(1), std::vector<double>{0});
    EXPECT_TRUE(SpeedCurve{}.sampled(0).empty());
}

TEST(SpeedCurve, PassesThroughItsPoints) {
    for (const SpeedCurve& curve :
         {SpeedCurve{{{0, 0}, {0.5f, 0.125f}, {1, 1}}},
          SpeedCurve{{{0, 0}, {0.25f, 0.5f}, {0.5f, 0.5f}, {0.75f, 0.875f}, {1, 1}}}}) {
        const std::vector<double> values = curve.sampled(65);
        for (const glm::vec2& point : curve.points)
            EXPECT_NEAR(values[std::size_t(std::lround(point.x * 64))], double(point.y), 1e-12);
    }
}

TEST(SpeedCurve, ThreePointsBendSmoothly) {
    // By hand: slopes 0.5 and 1.5 on equal halves; harmonic mean 0.75 in the middle, the sides' own at the
    // ends. At x = 0.25 the Hermite cubic gives 0.125 + 0.5 (0.5 - 0.75) / 8.
    const std::vector<double> values = SpeedCurve{{{0, 0}, {0.5f, 0.25f}, {1, 1}}}.sampled(5);
    EXPECT_NEAR(values[1], 0.125 - 0.25 * 0.5 / 8, 1e-12);
}

TEST(SpeedCurve, NeverFallsNorLeavesTheUnitRange) {
    Random random(11);
    for (int round = 0; round < 200; ++round) {
        SpeedCurve curve;
        curve.points = {{0, 0}};
        const int inner = int(random.below(20));
        for (int i = 1; i <= inner; ++i)
            curve.points.push_back(
                {float(i) / float(inner + 1),
                 random.uniform() < 0.3
                     ? curve.points.back().y
                     : std::min(1.0f, curve.points.back().y + float(random.uniform()) * 0.4f)});
        curve.points.push_back({1, 1});
        const std::vector<double> values = curve.sampled(500);
        EXPECT_EQ(values.front(), 0);
        EXPECT_EQ(values.back(), 1);
        EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    }
}

TEST(SpeedCurve, RefusesBrokenRules) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::vector<glm::vec2>> broken{{},
                                                     {{0, 0}},
                                                     {{0, 0.1f}, {1, 1}},
                                                     {{0, 0}, {0.9f, 1}},
                                                     {{0, 0}, {0.5f, 0.6f}, {0.7f, 0.5f}, {1, 1}},
                                                     {{0, 0}, {0.5f, 0.2f}, {0.5f, 0.5f}, {1, 1}},
                                                     {{0, 0}, {nan, 0.5f}, {1, 1}},
                                                     {{0, 0}, {0.5f, nan}, {1, 1}}};
    for (const auto& points : broken) EXPECT_THROW(SpeedCurve{points}.sampled(8), Error);
}

Gradient ramp(const std::vector<double>& values) {
    Gradient colors;
    for (const double value : values) colors.emplace_back(float(value), 0.5f * float(value), 0.2f);
    return colors;
}

double rms(const Gradient& a, const Gradient& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += double(glm::dot(a[i] - b[i], a[i] - b[i]));
    return std::sqrt(sum / (3.0 * double(a.size())));
}

TEST(MatchSpeed, FindsTheCurveThatWasUsed) {
    const Gradient gradient = ramp(SpeedCurve{}.sampled(400));
    const SpeedCurve truth{{{0, 0}, {0.3f, 0.1f}, {0.6f, 0.8f}, {1, 1}}};
    const SpeedCurve found = matchSpeed(gradient, ramp(truth.sampled(400)));
    const std::vector<double> expected = truth.sampled(101), values = found.sampled(101);
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(values[i], expected[i], 0.03) << i;
    EXPECT_LE(found.points.size(), 24u);
}

TEST(MatchSpeed, LeavesAnEvenStripAlone) {
    const Gradient gradient = ramp(SpeedCurve{}.sampled(300));
    EXPECT_EQ(matchSpeed(gradient, gradient), SpeedCurve{});
    const Gradient flat(200, glm::vec3(0.4f));
    EXPECT_EQ(matchSpeed(flat, flat), SpeedCurve{});
}

TEST(MatchSpeed, DoesNotFollowStreaks) {
    // An even ramp whose columns are off by up to a tenth, each for itself.
    Random random(2);
    const Gradient gradient = ramp(SpeedCurve{}.sampled(600));
    Gradient streaked = gradient;
    for (glm::vec3& color : streaked) color += glm::vec3(0.2f * float(random.uniform() - 0.5));
    const std::vector<double> pace = matchSpeed(gradient, streaked).sampled(600);
    for (std::size_t i = 1; i < pace.size(); ++i) {
        const double slope = (pace[i] - pace[i - 1]) * 599;
        EXPECT_GT(slope, 0.5) << i;
        EXPECT_LT(slope, 2.0) << i;
    }
}

TEST(MatchSpeed, NeverIncreasesTheResidue) {
    Random random(4);
    for (int round = 0; round < 20; ++round) {
        Gradient gradient, averages;
        for (int i = 0; i < 80; ++i) {
            gradient.emplace_back(float(random.uniform()), float(random.uniform()), float(random.uniform()));
            averages.emplace_back(float(random.uniform()), float(random.uniform()), float(random.uniform()));
        }
        const SpeedCurve curve = matchSpeed(gradient, averages, 2 + round);
        EXPECT_LE(curve.points.size(), std::size_t(2 + round));
        EXPECT_LE(rms(atSpeed(gradient, curve), averages), rms(gradient, averages));
    }
}

TEST(MatchSpeed, TakesAnyWidth) {
    for (const int width : {1, 2, 3, 4, 23, 64})
        EXPECT_NO_THROW(matchSpeed(Gradient(std::size_t(width), glm::vec3(0.1f)),
                                   Gradient(std::size_t(width), glm::vec3(0.9f)))
                            .sampled(width));
}

}  // namespace
}  // namespace chiaro::gradient
