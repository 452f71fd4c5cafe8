#include "core/metrics/study.h"

#include "core/base/error.h"
#include "core/metrics/distortion.h"
#include "tests/core/metrics/pictures.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ranges>

namespace chiaro::metrics {
namespace {

TEST(Distortion, QuarterTurnsAreExact) {
    const ColorImage picture = test::speckled(21, 21, 1);
    const ColorImage turned = rotated(picture, 90), upended = rotated(picture, 180);
    for (int y = 0; y < 21; ++y)
        for (int x = 0; x < 21; ++x) {
            for (int c = 0; c < 3; ++c) {
                ASSERT_NEAR(turned(20 - y, x)[c], picture(x, y)[c], 1e-5);
                ASSERT_NEAR(upended(20 - x, 20 - y)[c], picture(x, y)[c], 1e-5);
            }
        }
    EXPECT_EQ(rotated(picture, 0), picture);
}

TEST(Distortion, ScalesAboutTheCentre) {
    ColorImage picture(40, 40, glm::vec3(0));
    for (int y = 10; y < 30; ++y)
        for (int x = 10; x < 30; ++x) picture(x, y) = glm::vec3(1);
    const ColorImage half = scaled(picture, 0.5, 1);
    EXPECT_EQ(half(15, 20), glm::vec3(1));
    EXPECT_EQ(half(14, 20), glm::vec3(0));
    EXPECT_EQ(half(20, 10), glm::vec3(1));
    EXPECT_EQ(half(20, 9), glm::vec3(0));
    EXPECT_EQ(scaled(picture, 1, 1), picture);
    EXPECT_EQ(scaled(picture, 1, 2)(20, 5), glm::vec3(1));
    EXPECT_EQ(scaled(picture, 1, 2)(5, 20), glm::vec3(0));
    EXPECT_THROW(scaled(picture, 0, 1), Error);
}

TEST(Distortion, TornPiecesComeFromTheStripeAboutThem) {
    // Columns tell where a pixel came from.
    ColorImage picture(128, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 128; ++x) picture(x, y) = glm::vec3(float(x) / 127, float(y) / 63, 0);
    for (const int block : {4, 16, 32}) {
        const ColorImage result = torn(picture, block, 1);
        ASSERT_EQ(result.width(), 128);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 128; ++x)
                ASSERT_LE(std::abs(result(x, y).r * 127 - float(x)), 1.5f * float(block)) << x << " " << y;
        EXPECT_EQ(result, torn(picture, block, 1));
        EXPECT_NE(result, torn(picture, block, 2));
    }
    EXPECT_THROW(torn(test::part(picture, 0, 0, 40, 20), 32, 1), Error);
}

/// One curve: error by strength.
std::map<double, double> curve(const std::vector<StudyPoint>& points, const std::string& texture,
                               Distortion distortion, int block) {
    std::map<double, double> result;
    for (const StudyPoint& point : points)
        if (point.texture == texture && point.distortion == distortion && point.block == block)
            result[point.strength] = point.error.mean;
    return result;
}

class Study : public testing::Test {
protected:
    static void SetUpTestSuite() {
        StudyParams params;
        params.blocks = {8, 12};
        s_points = runStudy(builtInTextures(), params);
    }
    static inline std::vector<StudyPoint> s_points;
};

TEST_F(Study, StripesPeakAcrossTheirDirectionAndComeBack) {
    for (const int block : {8, 12}) {
        const auto error = curve(s_points, "diagonal", Distortion::Rotation, block);
        EXPECT_EQ(error.at(0), 0);
        EXPECT_GE(error.at(45), 2 * error.at(180)) << block;
        EXPECT_GE(error.at(135), 2 * error.at(180)) << block;
        EXPECT_LT(error.at(90), 0.95 * std::min(error.at(45), error.at(135))) << block;
    }
}

// A quarter turn makes stripes at 45 degrees their own mirror image, and half a turn makes them themselves.
TEST_F(Study, StripesAnswerAlikeOnBothSidesOfAQuarterTurn) {
    for (const int block : {8, 12}) {
        const auto error = curve(s_points, "diagonal", Distortion::Rotation, block);
        for (const int angle : {15, 30, 45, 60, 75})
            EXPECT_NEAR(error.at(90 - angle) / error.at(90 + angle), 1, 0.15) << block << " " << angle;
    }
}

TEST_F(Study, IsotropicTexturesStayFlatAndLow) {
    for (const int block : {8, 12}) {
        const auto stripes = curve(s_points, "diagonal", Distortion::Rotation, block);
        const double peak = std::ranges::max(stripes | std::views::values);
        for (const char* texture : {"random", "symmetric"}) {
            const auto error = curve(s_points, texture, Distortion::Rotation, block);
            double least = 1, most = 0;
            for (const auto& [angle, value] : error) {
                if (angle < 45) continue;
                least = std::min(least, value);
                most = std::max(most, value);
            }
            EXPECT_LE(most, 1.3 * least) << texture << " " << block;
            EXPECT_LT(most, 0.5 * peak) << texture << " " << block;
        }
    }
}

TEST_F(Study, ScaleGrowsOnBothSidesOfOne) {
    for (const int block : {8, 12})
        for (const char* texture : {"random", "diagonal", "symmetric"})
            for (const Distortion axis : {Distortion::ScaleX, Distortion::ScaleY, Distortion::ScaleBoth}) {
                const auto error = curve(s_points, texture, axis, block);
                const std::string name = std::string(texture) + " " + nameOf(axis);
                EXPECT_EQ(error.at(1), 0) << name;
                EXPECT_GT(error.at(0.5), error.at(std::exp2(-0.25))) << name;
                EXPECT_GT(error.at(std::exp2(-0.25)), 0) << name;
                EXPECT_GT(error.at(2), error.at(std::exp2(0.25))) << name;
                EXPECT_GT(error.at(std::exp2(0.25)), 0) << name;
            }
}

TEST_F(Study, DiscontinuityFallsWithTheBlocks) {
    for (const int block : {8, 12})
        for (const char* texture : {"random", "diagonal", "symmetric"}) {
            const auto error = curve(s_points, texture, Distortion::Discontinuity, block);
            EXPECT_GT(error.at(4), 1.2 * error.at(32)) << texture << " " << block;
            EXPECT_GT(error.at(12), error.at(32)) << texture << " " << block;
        }
}

TEST_F(Study, TablesAndFiguresHoldEveryPoint) {
    const std::string csv = studyCsv(s_points);
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "texture,distortion,block,value,error,standard_error,pixels");
    EXPECT_EQ(std::size_t(std::ranges::count(csv, '\n')), s_points.size() + 1);
    EXPECT_NE(csv.find("\nrandom,rotation,8,45,0."), std::string::npos);
    std::size_t circles = 0;
    for (const StudyFigure& figure : studyFigures(s_points)) {
        const std::string svg = figure.svg();
        for (std::size_t at = 0; (at = svg.find("<circle", at)) != std::string::npos; ++at) ++circles;
        // The same at twice the size, with something on it.
        const ColorImage picture = figure.picture();
        EXPECT_NE(
            svg.find(fmt::format(R"(width="{}" height="{}")", picture.width() / 2, picture.height() / 2)),
            std::string::npos);
        EXPECT_GT(std::ranges::count_if(picture.pixels(), [](glm::vec3 c) { return c != glm::vec3(1); }),
                  10000);
    }
    EXPECT_EQ(circles, s_points.size());
}

TEST(StudyParts, SmallSamplesAreRefusedByName) {
    try {
        StudyParams params;
        params.blocks = {8};
        runStudy({{"scrap.png", test::speckled(64, 30, 1)}}, params);
        FAIL();
    } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("scrap.png")) << error.what();
    }
}

TEST(LineChart, EscapesNamesAndStandsEmptyCharts) {
    LineChart chart;
    chart.title = "a < b & \"c\"";
    EXPECT_NE(svgOf({chart}, 1).find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
    chart.series.push_back({"one", {{1, 0.5, 0.1}}});
    const std::string svg = svgOf({chart, LineChart{}}, 2);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST(LineChart, PicturesShowTheCurveWhereItsValuesAre) {
    LineChart chart;
    chart.y.ticks = {0, 1};
    chart.series.push_back({"flat", {{0, 0.5}, {1, 0.5}}});
    const ColorImage picture = pictureOf({chart}, 1);
    // The blue curve runs level, half way up the plot, and nowhere above it.
    int rows = 0, sum = 0;
    for (int y = 60; y < picture.height() / 2 + 60; ++y) {
        const glm::vec3 color = picture(picture.width() / 2, y);
        if (!(color.b > color.r + 0.3f)) continue;
        ++rows;
        sum += y;
    }
    ASSERT_GT(rows, 0);
    EXPECT_LE(rows, 5);
    EXPECT_NEAR(double(sum) / rows, 2 * (34 + (270 - 34 - 72) / 2.0), 1);
    EXPECT_EQ(pictureOf({}, 3).width(), 2 * 360);
    LineChart named = chart;
    named.title = "Öl \"☃\" <&>";
    EXPECT_NE(pictureOf({named}, 1), picture);
}

}  // namespace
}  // namespace chiaro::metrics
