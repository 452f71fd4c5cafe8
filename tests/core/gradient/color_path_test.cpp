#include "core/gradient/color_path.h"

#include "core/base/color.h"
#include "core/base/error.h"

#include <gtest/gtest.h>

namespace chiaro::gradient {
namespace {

void expectNear(glm::vec3 color, glm::vec3 expected, float tolerance = 1e-6f) {
    EXPECT_NEAR(color.r, expected.r, tolerance);
    EXPECT_NEAR(color.g, expected.g, tolerance);
    EXPECT_NEAR(color.b, expected.b, tolerance);
}

TEST(ColorPath, InterpolatesBetweenStopsAndHoldsBeyond) {
    const ColorPath path{{{0.25f, {0, 0, 0}}, {0.75f, {1, 0.5f, 0}}}};
    expectNear(path.at(0), {0, 0, 0});
    expectNear(path.at(0.5f), {0.5f, 0.25f, 0});
    expectNear(path.at(0.75f), {1, 0.5f, 0});
    expectNear(path.at(1), {1, 0.5f, 0});
}

TEST(ColorPath, StopsAtOnePlaceMakeAStep) {
    const ColorPath path{
        {{0, glm::vec3(0)}, {0.5f, glm::vec3(0.2f)}, {0.5f, glm::vec3(0.8f)}, {1, glm::vec3(1)}}};
    EXPECT_LT(path.at(0.499f).r, 0.201f);
    expectNear(path.at(0.5f), glm::vec3(0.8f));
}

TEST(ColorPath, OneStopIsConstant) {
    const ColorPath path{{{0.5f, {0.1f, 0.2f, 0.3f}}}};
    for (const glm::vec3& color : path.sampled(3)) expectNear(color, {0.1f, 0.2f, 0.3f});
    EXPECT_EQ(path.sampled(1).size(), 1u);
}

TEST(ColorPath, OklabMeetsTheStopsAndMixesByLightness) {
    const ColorPath path{{{0, {0, 0, 0}}, {1, {1, 1, 1}}}, ColorPath::Space::Oklab};
    expectNear(path.at(0), glm::vec3(0), 1e-5f);
    expectNear(path.at(1), glm::vec3(1), 1e-5f);
    // Half of Oklab's lightness is an eighth of the light.
    expectNear(path.at(0.5f), glm::vec3(srgbFromLinear(0.125f)), 1e-4f);
}

TEST(ColorPath, IsReadFromText) {
    const ColorPath path = parseColorPath("1 #fff, 0 #201040 ,0.5 #c04020", ColorPath::Space::Oklab);
    ASSERT_EQ(path.stops.size(), 3u);
    EXPECT_EQ(path.space, ColorPath::Space::Oklab);
    EXPECT_EQ(path.stops[0].position, 0);
    EXPECT_EQ(path.stops[1].color, colorFromHex("#c04020"));
    EXPECT_EQ(path.stops[2].color, glm::vec3(1));
    EXPECT_EQ(colorPathText(path), "0 #201040, 0.5 #c04020, 1 #ffffff");
    EXPECT_EQ(parseColorPath(colorPathText(path), path.space), path);
}

TEST(ColorPath, RefusesOtherText) {
    for (const char* text : {"", " ", "#201040", "0", "0 red", "0 #201040 0.5 #c04020", "-0.1 #fff",
                             "1.5 #fff", "nan #fff", "0 #fff,,1 #000", "0 #ff"})
        EXPECT_THROW(parseColorPath(text), Error) << text;
}

}  // namespace
}  // namespace chiaro::gradient
