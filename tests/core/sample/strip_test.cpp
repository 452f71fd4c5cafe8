#include "core/sample/strip.h"

#include "core/base/error.h"
#include "core/base/image_io.h"
#include "tests/support/support.h"

#include <limits>

namespace chiaro::sample {
namespace {

using namespace test;

/// Every pixel tells its place: red is x, green is y.
ColorImage coordinates(int width, int height) {
    ColorImage image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image(x, y) = {float(x) / 256, float(y) / 256, float((x * 7 + y) % 5) / 4};
    return image;
}

std::array<glm::vec2, 4> rectangle(float left, float top, float right, float bottom) {
    return {glm::vec2{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

std::string refusal(const ColorImage& scan, const StripParams& params) {
    try {
        makeStrip(scan, params);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Strip, DefaultsReturnTheScanBitForBit) {
    const ColorImage scan = coordinates(100, 40);
    EXPECT_EQ(makeStrip(scan), scan);
}

TEST(Strip, QuarterTurnsAreClockwiseAndExact) {
    const ColorImage scan = coordinates(70, 90);
    StripParams params;
    params.quarterTurns = 1;
    const ColorImage once = makeStrip(scan, params);
    ASSERT_EQ(once.width(), 90);
    ASSERT_EQ(once.height(), 70);
    EXPECT_EQ(once(89, 0), scan(0, 0));  // top-left goes to the top-right
    EXPECT_EQ(once(0, 0), scan(0, 89));
    params.quarterTurns = 2;
    EXPECT_EQ(makeStrip(scan, params)(0, 0), scan(69, 89));
    params.quarterTurns = 3;
    EXPECT_EQ(makeStrip(scan, params)(0, 69), scan(0, 0));
    EXPECT_EQ(makeStrip(once, params), scan);
}

TEST(Strip, MirrorSwapsLeftAndRight) {
    const ColorImage scan = coordinates(80, 20);
    StripParams params;
    params.mirror = true;
    const ColorImage mirrored = makeStrip(scan, params);
    EXPECT_EQ(mirrored(0, 3), scan(79, 3));
    EXPECT_EQ(makeStrip(mirrored, params), scan);
}

TEST(Strip, CropOfWholePixelsIsExact) {
    const ColorImage scan = coordinates(200, 100);
    StripParams params;
    params.crop = rectangle(20 / 200.0f, 10 / 100.0f, 150 / 200.0f, 73 / 100.0f);
    const ColorImage strip = makeStrip(scan, params);
    ASSERT_EQ(strip.width(), 130);
    ASSERT_EQ(strip.height(), 63);
    for (int y = 0; y < 63; ++y)
        for (int x = 0; x < 130; ++x) ASSERT_EQ(strip(x, y), scan(20 + x, 10 + y));
}

TEST(Strip, CropBetweenPixelsIsExactOnARamp) {
    // Bicubic interpolation reproduces a linear ramp, so each pixel tells where it was taken, to a hundredth
    // of what fixed-point warps can.
    const ColorImage scan = coordinates(200, 100);
    StripParams params;
    params.crop = rectangle(20.25f / 200, 10.5f / 100, 150.25f / 200, 73.5f / 100);
    const ColorImage strip = makeStrip(scan, params);
    ASSERT_EQ(strip.width(), 130);
    ASSERT_EQ(strip.height(), 63);
    for (int y = 0; y < 63; ++y) {
        for (int x = 0; x < 130; ++x) {
            ASSERT_NEAR(strip(x, y).r * 256, x + 20.25, 3e-4);
            ASSERT_NEAR(strip(x, y).g * 256, y + 10.5, 3e-4);
        }
    }
}

TEST(Strip, TurnedCropIsStraightened) {
    // A rectangle of 100 x 40 pixels turned by the angle whose sine is 3/5, its top-left corner at (60, 30).
    const ColorImage scan = coordinates(200, 160);
    const auto corner = [](double x, double y) {
        return glm::vec2(float((60 + 0.8 * x - 0.6 * y) / 200), float((30 + 0.6 * x + 0.8 * y) / 160));
    };
    StripParams params;
    params.crop = {corner(0, 0), corner(100, 0), corner(100, 40), corner(0, 40)};
    const ColorImage strip = makeStrip(scan, params);
    ASSERT_EQ(strip.width(), 100);
    ASSERT_EQ(strip.height(), 40);
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 100; ++x) {
            const double u = x + 0.5, v = y + 0.5;
            ASSERT_NEAR(strip(x, y).r * 256, 60 + 0.8 * u - 0.6 * v - 0.5, 1e-3);
            ASSERT_NEAR(strip(x, y).g * 256, 30 + 0.6 * u + 0.8 * v - 0.5, 1e-3);
        }
    }
}

TEST(Strip, CropSizeIsTheMeanOfOppositeEdges) {
    const ColorImage scan = coordinates(200, 100);
    StripParams params;
    params.crop = {glm::vec2{0.0f, 0.0f}, {1.0f, 0.2f}, {1.0f, 0.8f}, {0.0f, 1.0f}};
    const ColorImage strip = makeStrip(scan, params);
    EXPECT_EQ(strip.width(), int(std::lround(std::hypot(200, 20))));
    EXPECT_EQ(strip.height(), 80);
}

TEST(Strip, ScalingKeepsTheMean) {
    ColorImage scan(160, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 160; ++x) scan(x, y) = glm::vec3(x % 2 == y % 2 ? 1.0f : 0.0f);
    StripParams params;
    params.scale = 0.5;
    const ColorImage half = makeStrip(scan, params);
    ASSERT_EQ(half.width(), 80);
    ASSERT_EQ(half.height(), 32);
    for (const glm::vec3& pixel : half.pixels()) ASSERT_EQ(pixel, glm::vec3(0.5f));
}

TEST(Strip, EnlargingKeepsFlatColourAndStaysInRange) {
    StripParams params;
    params.scale = 1.75;
    const ColorImage flat = makeStrip(ColorImage(64, 16, glm::vec3(0.3f)), params);
    ASSERT_EQ(flat.width(), 112);
    ASSERT_EQ(flat.height(), 28);
    for (const glm::vec3& pixel : flat.pixels()) ASSERT_NEAR(pixel.g, 0.3f, 1e-6);
    ColorImage edge(64, 16, glm::vec3(0));
    for (int y = 0; y < 16; ++y)
        for (int x = 32; x < 64; ++x) edge(x, y) = glm::vec3(1);
    for (const glm::vec3& pixel : makeStrip(edge, params).pixels()) ASSERT_TRUE(pixel.r >= 0 && pixel.r <= 1);
}

TEST(Strip, RefusesSizesOutsideTheRule) {
    StripParams params;
    EXPECT_EQ(refusal(coordinates(64, 16), params), "");
    EXPECT_EQ(refusal(coordinates(63, 16), params).find("strip: is 63 x 16 pixels; a strip is 64 to 8192"),
              0u);
    EXPECT_NE(refusal(coordinates(64, 15), params), "");
    EXPECT_NE(refusal(coordinates(1, 1), params), "");
    EXPECT_NE(refusal(ColorImage(8193, 16), params), "");
    EXPECT_NE(refusal(ColorImage(64, 4097), params), "");
    params.scale = 8;  // refused before a picture of that size is made
    EXPECT_NE(refusal(ColorImage(1100, 100), params), "");
    params = {};
    params.quarterTurns = 1;  // 16 wide and 64 high once turned
    EXPECT_NE(refusal(coordinates(64, 16), params), "");
}

TEST(Strip, RefusesImpossibleCrops) {
    const ColorImage scan = coordinates(200, 100);
    StripParams params;
    params.crop = {glm::vec2{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    EXPECT_NE(refusal(scan, params).find("crop: "), std::string::npos) << "a bow tie";
    params.crop = {glm::vec2{1, 0}, {0, 0}, {0, 1}, {1, 1}};
    EXPECT_NE(refusal(scan, params), "") << "the wrong way round";
    params.crop = {glm::vec2{0, 0}, {1, 0}, {0.4f, 0.4f}, {0, 1}};
    EXPECT_NE(refusal(scan, params), "") << "a dent";
    params.crop = {glm::vec2{-0.1f, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_NE(refusal(scan, params), "") << "outside";
    params.crop = {glm::vec2{std::numeric_limits<float>::quiet_NaN(), 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_NE(refusal(scan, params), "") << "not a number";
    params.crop = {glm::vec2{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}};
    EXPECT_NE(refusal(scan, params), "") << "a point";
}

TEST(Strip, RefusesParametersOutOfRange) {
    StripParams params;
    params.quarterTurns = 4;
    EXPECT_NE(refusal(coordinates(100, 100), params), "");
    params = {};
    params.scale = 0.01;
    EXPECT_NE(refusal(coordinates(100, 100), params), "");
}

}  // namespace
}  // namespace chiaro::sample
