#include "core/base/error.h"
#include "tests/core/metrics/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace chiaro::metrics {
namespace {

using test::speckled;

/// Grey levels of 8 bits, row by row.
ColorImage greys(int width, std::vector<int> levels) {
    ColorImage picture(width, int(levels.size()) / width);
    for (std::size_t i = 0; i < levels.size(); ++i)
        picture.pixels()[i] = glm::vec3(float(levels[i]) / 255.0f);
    return picture;
}

TEST(Descriptor, ChannelsAreTheReportsFilters) {
    const ChannelImage channels = channelImages(greys(3, {1, 2, 4,    //
                                                          8, 16, 32,  //
                                                          64, 128, 250}));
    constexpr int step = 257;  // an 8-bit level
    const auto& middle = channels(1, 1);
    EXPECT_EQ(middle[0], 16 * step);
    EXPECT_EQ(middle[3], (4 + 32 + 250 - 1 - 8 - 64) * step);   // vertical edges
    EXPECT_EQ(middle[6], (64 + 128 + 250 - 1 - 2 - 4) * step);  // horizontal
    EXPECT_EQ(middle[9], 3 * (4 - 64) * step);                  // diagonals
    EXPECT_EQ(middle[12], 3 * (250 - 1) * step);
    // At the corner the border is replicated: the neighbourhood is 1 1 2; 1 1 2; 8 8 16.
    const auto& corner = channels(0, 0);
    EXPECT_EQ(corner[3], (2 + 2 + 16 - 1 - 1 - 8) * step);
    EXPECT_EQ(corner[6], (8 + 8 + 16 - 1 - 1 - 2) * step);
    EXPECT_EQ(corner[9], 3 * (2 - 8) * step);
    EXPECT_EQ(corner[12], 3 * (16 - 1) * step);
}

TEST(Descriptor, ColoursKeepToTheirChannel) {
    ColorImage picture(3, 3, glm::vec3(0));
    picture(2, 1) = {0, 1, 0};
    const auto& middle = channelImages(picture)(1, 1);
    EXPECT_EQ(middle[3], 0);
    EXPECT_EQ(middle[4], 65535);
    EXPECT_EQ(middle[5], 0);
    picture(0, 0) = glm::vec3(std::numeric_limits<float>::quiet_NaN(), 2, -1);
    EXPECT_EQ(channelImages(picture)(0, 0)[0], 0);
    EXPECT_EQ(channelImages(picture)(0, 0)[1], 65535);
    EXPECT_EQ(channelImages(picture)(0, 0)[2], 0);
}

TEST(Descriptor, EdgesAreQuantilesWithLinearInterpolation) {
    // 0..10: p = k, so edge k is k itself.
    const Bins eleven = binsOf(greys(11, {10, 3, 0, 7, 5, 1, 9, 2, 8, 4, 6}));
    for (int k = 1; k <= 9; ++k) EXPECT_EQ(eleven.edges[0][std::size_t(k - 1)], k * 257) << k;
    // Two values: p = k / 10 lies between them, and the edge is rounded up to a whole step.
    const Bins two = binsOf(greys(2, {0, 1}));
    for (int k = 1; k <= 9; ++k) EXPECT_EQ(two.edges[1][std::size_t(k - 1)], (k * 257 + 9) / 10) << k;
}

TEST(Descriptor, AValueOnAnEdgeGoesUp) {
    const ColorImage source = greys(11, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    const BinImage image = binned(source, binsOf(source));
    for (int x = 0; x < 11; ++x) EXPECT_EQ(image(x, 0)[0], std::min(x, 9)) << x;
    // Where half of the source is one value, the bins below its last edge stay empty.
    const ColorImage half = greys(10, {5, 5, 5, 5, 5, 5, 6, 7, 8, 9});
    EXPECT_EQ(binned(half, binsOf(half))(0, 0)[0], 5);
    EXPECT_EQ(binned(greys(1, {4}), binsOf(half))(0, 0)[0], 0);
}

TEST(Descriptor, CountsTheBlockAroundAPixel) {
    const ColorImage picture = speckled(20, 15, 3);
    const BinImage image = binned(picture, binsOf(picture));
    for (const int size : {4, 5, 8, 13}) {
        const Block block({10, 7}, size);
        EXPECT_EQ(block.corner, glm::ivec2(10 - size / 2, 7 - size / 2));
        const Descriptor descriptor = describe(image, block);
        Descriptor expected{};
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                for (std::size_t channel = 0; channel < channelCount; ++channel)
                    ++expected[channel * 10 + image(10 - size / 2 + x, 7 - size / 2 + y)[channel]];
        EXPECT_EQ(descriptor, expected);
    }
    EXPECT_TRUE(Block({4, 4}, 8).isInside(8, 8));
    EXPECT_FALSE(Block({3, 4}, 8).isInside(8, 8));
    EXPECT_FALSE(Block({5, 4}, 8).isInside(8, 8));
}

TEST(Descriptor, ACounterRunsAlongARow) {
    const ColorImage picture = speckled(30, 9, 4);
    const BinImage image = binned(picture, binsOf(picture));
    BlockCounter counter(image, {0, 1}, 6);
    for (int x = 0; x <= 24; ++x) {
        if (x > 0) counter.advance();
        ASSERT_EQ(counter.descriptor(), describe(image, {{x + 3, 4}, 6})) << x;
    }
}

TEST(Descriptor, DistanceAddsHistograms) {
    Descriptor a{}, b{};
    for (std::size_t channel = 0; channel < channelCount; ++channel) a[channel * 10] = b[channel * 10] = 16;
    EXPECT_EQ(distance(a, b, 4), 0);
    b[0] = 12, b[1] = 4;    // 4 sqrt 2
    b[10] = 0, b[15] = 16;  // 16 sqrt 2
    EXPECT_NEAR(distance(a, b, 4), 20 * std::sqrt(2.0) / (15 * 16), 1e-15);
    EXPECT_EQ(distance(a, b, 4), distance(b, a, 4));
}

TEST(Descriptor, RefusesSourcesOfOneColour) {
    EXPECT_THROW(binsOf(ColorImage(30, 20, glm::vec3(0.3f))), Error);
    EXPECT_THROW(binsOf(ColorImage()), Error);
}

}  // namespace
}  // namespace chiaro::metrics
