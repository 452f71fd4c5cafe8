#include "core/base/image_layout.h"

#include <gtest/gtest.h>

#include <limits>

namespace chiaro {
namespace {

TEST(ImageLayout, ChannelsAreFoundByName) {
    EXPECT_EQ(chooseByName({"B", "G", "R"}), (ChannelChoice{2, 1, 0}));
    EXPECT_EQ(chooseByName({"A", "B", "G", "R", "Z"}), (ChannelChoice{3, 2, 1, 0}));
    EXPECT_EQ(chooseByName({"Y", "A"}), (ChannelChoice{0, 1}));
    EXPECT_EQ(chooseByName({"Z"}), (ChannelChoice{0}));
    EXPECT_EQ(chooseByName({"depth.Z", "left.B", "left.G", "left.R"}), (ChannelChoice{3, 2, 1}));
    EXPECT_TRUE(chooseByName({"X", "Z"}).empty());
    EXPECT_TRUE(chooseByName({"R", "G"}).empty());
}

TEST(ImageLayout, VectorsAreTwoPlainChannels) {
    EXPECT_EQ(chooseVectors({"X", "Y"}), (ChannelChoice{0, 1}));
    EXPECT_EQ(chooseVectors({"Y", "Z", "X"}), (ChannelChoice{2, 0}));
    EXPECT_EQ(chooseVectors({"R", "motion.X", "motion.Y"}), (ChannelChoice{1, 2}));
    EXPECT_EQ(chooseVectors({"B", "G", "R"}), (ChannelChoice{2, 1}));
    EXPECT_TRUE(chooseVectors({"Y"}).empty());
    EXPECT_TRUE(chooseVectors({"X", "other.Y"}).empty());
}

TEST(ImageLayout, ChannelsAreCounted) {
    EXPECT_EQ(chooseByCount(1, -1), (ChannelChoice{0}));
    EXPECT_EQ(chooseByCount(2, 1), (ChannelChoice{0, 1}));
    EXPECT_EQ(chooseByCount(3, -1), (ChannelChoice{0, 1, 2}));
    EXPECT_EQ(chooseByCount(4, 3), (ChannelChoice{0, 1, 2, 3}));
    EXPECT_EQ(chooseByCount(4, -1), (ChannelChoice{0, 1, 2}));
    EXPECT_EQ(chooseByCount(6, 5), (ChannelChoice{0, 1, 2, 5}));
}

TEST(ImageLayout, DividesByCoverageWhereThereIsAny) {
    DecodedImage image{3, 1, 2, false, {0.2f, 0.5f, 0.3f, 0.0f, 0.7f, 1.0f}};
    unpremultiply(image);
    EXPECT_EQ(image.values, (std::vector<float>{0.4f, 0.5f, 0.3f, 0.0f, 0.7f, 1.0f}));
    DecodedImage opaque{1, 1, 3, false, {0.2f, 0.5f, 0.5f}};
    unpremultiply(opaque);
    EXPECT_EQ(opaque.values, (std::vector<float>{0.2f, 0.5f, 0.5f}));
}

TEST(ImageLayout, PlacesAndCrops) {
    const DecodedImage image{2, 2, 1, false, {1, 2, 3, 4}};
    EXPECT_EQ(placed(image, 1, 1, 3, 3).values, (std::vector<float>{0, 0, 0, 0, 1, 2, 0, 3, 4}));
    EXPECT_EQ(placed(image, -1, -1, 2, 1).values, (std::vector<float>{4, 0}));
    EXPECT_EQ(placed(image, 5, 0, 2, 1).values, (std::vector<float>{0, 0}));
}

}  // namespace
}  // namespace chiaro
