#include "core/gradient/gradient.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/sample/strip.h"
#include "tests/core/gradient/literal_sort.h"
#include "tests/support/support.h"

#include <limits>

namespace chiaro::gradient {
namespace {

using namespace test;

float largestDifference(const ColorImage& a, const ColorImage& b) {
    float largest = 0;
    for (std::size_t i = 0; i < a.pixelCount(); ++i) {
        const glm::vec3 difference = glm::abs(a.pixels()[i] - b.pixels()[i]);
        largest = std::max({largest, difference.r, difference.g, difference.b});
    }
    return largest;
}

/// Dark to light with strokes, on 8-bit levels.
ColorImage paintedStrip(int width, int height, std::uint64_t seed = 1) {
    Random random(seed);
    ColorImage strip(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double shade = double(x) / (width - 1);
            const auto level = [&](double value) {
                return float(
                           std::lround(std::clamp(value + 0.3 * (random.uniform() - 0.5), 0.0, 1.0) * 255)) /
                       255.0f;
            };
            strip(x, y) = {level(shade), level(shade * shade), level(0.3 + 0.4 * shade)};
        }
    }
    return strip;
}

TEST(ColumnAverages, AreTheMeanOfEachColumn) {
    ColorImage strip(2, 4);
    for (int y = 0; y < 4; ++y) {
        strip(0, y) = {float(y) / 255.0f, 1, 0.25f};
        strip(1, y) = glm::vec3(y < 1 ? 1.0f : 0.0f);
    }
    const ExactColors averages = columnAverages(strip);
    ASSERT_EQ(averages.size(), 2u);
    EXPECT_EQ(averages[0], glm::dvec3(1.5 / 255, 1, 0.25));
    EXPECT_EQ(averages[1], glm::dvec3(0.25));
}

TEST(ColumnAverages, DoNotDependOnTheOrderOfPixels) {
    ColorImage strip = paintedStrip(2, 999);
    for (int y = 0; y < 999; ++y) strip(1, y) = strip(0, 998 - y);
    const ExactColors averages = columnAverages(strip);
    EXPECT_EQ(averages[0], averages[1]);
}

TEST(Resample, GoesFromEndToEnd) {
    const Gradient colors{glm::vec3(0), glm::vec3(0.5f), glm::vec3(0.25f)};
    EXPECT_EQ(resample(colors, 3), colors);
    EXPECT_EQ(resample(colors, 5), (Gradient{glm::vec3(0), glm::vec3(0.25f), glm::vec3(0.5f),
                                             glm::vec3(0.375f), glm::vec3(0.25f)}));
    EXPECT_EQ(resample(colors, 2), (Gradient{glm::vec3(0), glm::vec3(0.25f)}));
    EXPECT_EQ(resample({glm::vec3(0.7f)}, 3), Gradient(3, glm::vec3(0.7f)));
    EXPECT_EQ(resample(colors, 1), Gradient{glm::vec3(0)});
    EXPECT_TRUE(resample(colors, 0).empty());
}

TEST(LookUp, IsLinearAndHoldsTheEnds) {
    const Gradient gradient{glm::vec3(0), glm::vec3(1), glm::vec3(0.5f)};
    EXPECT_EQ(lookUp(gradient, 0.25), glm::vec3(0.5f));
    EXPECT_EQ(lookUp(gradient, 0.5), glm::vec3(1));
    EXPECT_EQ(lookUp(gradient, -3), glm::vec3(0));
    EXPECT_EQ(lookUp(gradient, 7), glm::vec3(0.5f));
    EXPECT_EQ(lookUp(gradient, std::numeric_limits<double>::quiet_NaN()), glm::vec3(0));
    EXPECT_EQ(lookUp({glm::vec3(0.3f)}, 0.5), glm::vec3(0.3f));
}

TEST(Separate, ByHand) {
    // Four columns, one row high: sorted 0, 0.4, 0.6, 1, and u is the identity.
    ColorImage strip(4, 1);
    const float shades[] = {0, 0.6f, 0.4f, 1};
    for (int x = 0; x < 4; ++x) strip(x, 0) = glm::vec3(shades[x]);
    GradientParams params;
    params.matchSpeed = false;
    const Separation separation = separate(strip, params);
    EXPECT_EQ(separation.order, (std::vector<int>{0, 2, 1, 3}));
    EXPECT_NEAR(separation.gradient[1].r, 0.4, 1e-7);
    EXPECT_NEAR(separation.texture(1, 0).r, 0.2, 1e-7);
    EXPECT_NEAR(separation.texture(2, 0).r, -0.2, 1e-7);
    EXPECT_NEAR(separation.residue, std::sqrt(2 * 0.04 / 4), 1e-7);
}

TEST(Separate, TextureAndGradientMakeTheStrip) {
    const ColorImage strip = paintedStrip(300, 40);
    for (const bool matchSpeed : {false, true}) {
        GradientParams params;
        params.matchSpeed = matchSpeed;
        const Separation separation = separate(strip, params);
        EXPECT_LE(largestDifference(recolored(separation.texture, separation.gradient), strip), 1e-6f);
        EXPECT_LE(separation.order.size(), 300u);
        EXPECT_EQ(separation.order.front(), 0);
        EXPECT_EQ(separation.order.back(), 299);
        EXPECT_EQ(separation.sorted.size(), 300u);
    }
}

TEST(Separate, UsesTheDrawnCurve) {
    GradientParams params;
    params.matchSpeed = false;
    params.curve.points = {{0, 0}, {0.5f, 0.25f}, {1, 1}};
    const Separation separation = separate(paintedStrip(101, 16), params);
    EXPECT_EQ(separation.curve, params.curve);
    const glm::vec3 expected = lookUp(separation.sorted, 0.25);
    EXPECT_NEAR(separation.gradient[50].r, expected.r, 1e-6);
    EXPECT_NEAR(separation.gradient[50].g, expected.g, 1e-6);
}

TEST(Separate, MatchedSpeedRestoresWhatTheSortForgets) {
    // Dark over three quarters, then a ramp: the sort keeps one dark column and stretches the ramp.
    ColorImage strip(400, 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 400; ++x)
            strip(x, y) = glm::vec3(x < 300 ? 0.1f : 0.1f + float(x - 300) / 99.0f * 0.8f);
    GradientParams drawn;
    drawn.matchSpeed = false;
    const Separation plain = separate(strip, drawn), matched = separate(strip);
    EXPECT_EQ(plain.order.size(), 100u);
    EXPECT_GT(plain.residue, 0.25);
    EXPECT_LT(matched.residue, 0.02);
}

TEST(Separate, RefusesParametersOutOfRange) {
    GradientParams params;
    params.searchScale = 0.5;
    EXPECT_THROW(separate(paintedStrip(64, 16), params), Error);
    params = {};
    params.matchSpeed = false;
    params.curve.points = {{0, 0}, {0.5f, 0.9f}, {0.6f, 0.1f}, {1, 1}};
    EXPECT_THROW(separate(paintedStrip(64, 16), params), Error);
}

TEST(Separate, StopsWhenCancelled) {
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(separate(paintedStrip(64, 16), {}, Task(source.get_token())), Cancelled);
}

TEST(Recolored, AddsTheOtherGradientAndClips) {
    ColorImage texture(2, 1);
    texture(0, 0) = {0.25f, -0.5f, 0.9f};
    const ColorImage result = recolored(texture, {glm::vec3(0.25f), glm::vec3(0.5f)});
    EXPECT_EQ(result(0, 0), glm::vec3(0.5f, 0, 1));
    EXPECT_EQ(result(1, 0), glm::vec3(0.5f));
    EXPECT_THROW(recolored(texture, Gradient(3)), Error);
}

class RealStrips : public testing::Test {
protected:
    static std::vector<std::filesystem::path> files() { return intactSamples(); }
    static ColorImage strip(const std::filesystem::path& path) {
        sample::StripParams params;
        params.mirror = path.string().find("reversed") != std::string::npos;
        return sample::makeStrip(sample::readScan(path), params);
    }
};

TEST_F(RealStrips, SeparateAndRecombine) {
    CHIARO_NEEDS_SHARED_DATA();
    ASSERT_GE(files().size(), 10u);
    for (const auto& path : files()) {
        const ColorImage original = strip(path);
        const Separation separation = separate(original);
        EXPECT_LE(largestDifference(recolored(separation.texture, separation.gradient), original), 1e-6f)
            << path;
        EXPECT_EQ(separation.order, LiteralSort(columnAverages(original), 1)()) << path;
        GradientParams plain;
        plain.matchSpeed = false;
        EXPECT_LE(separation.residue, separate(original, plain).residue) << path;
    }
}

TEST_F(RealStrips, SwappingTheGradientAndBackChangesNothing) {
    CHIARO_NEEDS_SHARED_DATA();
    const ColorImage original = strip(sharedData() / "samples" / "oil_jungfrau.png");
    const Separation separation = separate(original);
    const Gradient other = parseColorPath("0 #201040, 0.5 #c04020, 1 #fff0b0").sampled(original.width());
    const ColorImage texture = separation.texture;
    EXPECT_GT(largestDifference(recolored(texture, other), original), 0.1f);
    EXPECT_EQ(texture, separation.texture);
    EXPECT_LE(largestDifference(recolored(texture, separation.gradient), original), 1e-6f);
}

TEST(DemoStrips, SeparateAndRecombine) {
    for (const auto& path : filesIn(resource("demo/samples"))) {
        if (path.extension() != ".png") continue;
        const ColorImage original = sample::makeStrip(sample::readScan(path));
        const Separation separation = separate(original);
        EXPECT_LE(largestDifference(recolored(separation.texture, separation.gradient), original), 1e-6f)
            << path;
        EXPECT_EQ(separation.order, LiteralSort(columnAverages(original), 1)()) << path;
        EXPECT_LT(separation.residue, 0.03) << path << ": painted even, so the gradient follows it";
    }
}

}  // namespace
}  // namespace chiaro::gradient
