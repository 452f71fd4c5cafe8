#include "core/base/color.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

namespace chiaro {
namespace {

TEST(Color, TransferFunctionHasItsKnownValues) {
    EXPECT_NEAR(linearFromSrgb(0.5f), 0.214041f, 1e-6);
    EXPECT_NEAR(linearFromSrgb(0.04f), 0.04f / 12.92f, 1e-8);
    EXPECT_NEAR(srgbFromLinear(0.18f), 0.461356f, 1e-6);
    EXPECT_EQ(srgbFromLinear(0.0f), 0.0f);
    EXPECT_NEAR(srgbFromLinear(1.0f), 1.0f, 1e-6);
    EXPECT_FLOAT_EQ(linearFromSrgb(-0.5f), -linearFromSrgb(0.5f));
    for (int i = 0; i <= 255; ++i)
        EXPECT_NEAR(srgbFromLinear(linearFromSrgb(float(i) / 255.0f)), float(i) / 255.0f, 1e-6);
}

TEST(Color, OklabHasItsPublishedValues) {
    const glm::vec3 white = oklabFromSrgb(glm::vec3(1));
    EXPECT_NEAR(white.x, 1, 1e-4);
    EXPECT_NEAR(white.y, 0, 1e-4);
    EXPECT_NEAR(white.z, 0, 1e-4);
    const glm::vec3 red = oklabFromSrgb({1, 0, 0});
    EXPECT_NEAR(red.x, 0.62796, 1e-4);
    EXPECT_NEAR(red.y, 0.22486, 1e-4);
    EXPECT_NEAR(red.z, 0.12585, 1e-4);
    const glm::vec3 color(0.2f, 0.6f, 0.9f);
    EXPECT_LT(glm::distance(srgbFromOklab(oklabFromSrgb(color)), color), 1e-5f);
}

TEST(Color, HexIsReadAndWritten) {
    EXPECT_EQ(colorFromHex("#ff8000"), glm::vec3(1, 128 / 255.0f, 0));
    EXPECT_EQ(colorFromHex("#F80"), colorFromHex("#ff8800"));
    EXPECT_EQ(hexFromColor(colorFromHex("#c04020")), "#c04020");
    EXPECT_EQ(hexFromColor({-1, 2, 0.5f}), "#00ff80");
    for (const char* text : {"", "#", "ff8000", "#ff800", "#ff80000", "#gg0000", "red"})
        EXPECT_THROW(colorFromHex(text), Error) << text;
}

}  // namespace
}  // namespace chiaro
