#include "core/export/bake.h"

#include "core/base/random.h"
#include "tests/core/views/meshes.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace chiaro::exporting {
namespace {

/// One square face pair over texels 8..24 of 32.
Atlas squareAtlas() {
    Atlas atlas;
    atlas.size = 32;
    atlas.objects.push_back({{{{{8, 8}, {24, 8}, {24, 24}}}, {{{8, 8}, {24, 24}, {8, 24}}}}, {0, 0}});
    return atlas;
}

/// Grows from 0 to 1 from left to right over both faces of squareAtlas().
glm::vec3 ramp(std::size_t, std::uint32_t face, glm::vec2 place) {
    return glm::vec3(face == 0 ? place.x + place.y : place.x);
}

TEST(Bake, GivesATexelTheColourOfItsMiddle) {
    const ByteImage picture = bakeAtlas(squareAtlas(), ramp, {});
    for (int y = 8; y < 24; ++y)
        for (int x = 8; x < 24; ++x)
            EXPECT_NEAR(picture(x, y).r, (x + 0.5 - 8) / 16 * 255, 0.51) << x << ' ' << y;
}

TEST(Bake, AveragesSamplesWhereATexelHoldsMuch) {
    // Stripes finer than a texel: black and white by turns, eight to a texel.
    const auto stripes = [](std::size_t, std::uint32_t face, glm::vec2 place) {
        const float x = (face == 0 ? place.x + place.y : place.x) * 16;
        return glm::vec3(float(int(std::floor(x * 8)) % 2));
    };
    const ByteImage picture = bakeAtlas(squareAtlas(), stripes, {8, true});
    for (int x = 9; x < 23; ++x) EXPECT_NEAR(picture(x, 16).r, 127.5, 17) << x;
}

TEST(Bake, WithoutDilationLeavesBlackAround) {
    const auto white = [](std::size_t, std::uint32_t, glm::vec2) { return glm::vec3(1); };
    const ByteImage picture = bakeAtlas(squareAtlas(), white, {1, false});
    int whites = 0;
    for (const glm::u8vec3& pixel : picture.pixels()) whites += pixel == glm::u8vec3(255);
    EXPECT_EQ(whites, 16 * 16);
}

TEST(Bake, ShowsNoBackgroundAtMipLevel4) {
    views::ViewParams params;
    params.size = 96;
    const auto planned = methods::planObject(std::make_shared<const scene::Mesh>(test::ball(32, 16)), params);
    const Atlas atlas = makeAtlas({{planned, glm::mat4(1)}}, {256, 8});
    const auto red = [](std::size_t, std::uint32_t, glm::vec2) { return glm::vec3(1, 0.25f, 0); };
    const ByteImage picture = bakeAtlas(atlas, red, {});
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            glm::vec3 sum(0);
            for (int i = 0; i < 256; ++i) sum += glm::vec3(picture(x * 16 + i % 16, y * 16 + i / 16));
            EXPECT_EQ(sum / 256.0f, glm::vec3(255, 64, 0));
        }
}

TEST(Bake, ShowsAFaceThatLiesBetweenAllSamples) {
    Atlas atlas = squareAtlas();
    atlas.objects.push_back({{{{{2.01f, 2.01f}, {2.1f, 2.01f}, {2.01f, 2.1f}}}}, {1}});
    const auto objects = [](std::size_t object, std::uint32_t, glm::vec2) { return glm::vec3(object == 1); };
    const ByteImage picture = bakeAtlas(atlas, objects, {1, false});
    EXPECT_EQ(picture(2, 2), glm::u8vec3(255));
    EXPECT_EQ(picture(3, 3), glm::u8vec3(0));
}

TEST(Bake, IsTheSameWithAnyNumberOfThreads) {
    const ByteImage many = bakeAtlas(squareAtlas(), ramp, {});
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(bakeAtlas(squareAtlas(), ramp, {}), many);
}

TEST(Dilate, CopiesTheNearestCoveredPixel) {
    Random random(3);
    for (const int count : {1, 7, 60}) {
        const int width = 37, height = 29;
        ByteImage picture(width, height);
        Image<std::uint8_t> covered(width, height, 0);
        std::vector<glm::ivec2> sources;
        for (int i = 0; i < count; ++i) {
            const glm::ivec2 place(int(random.below(37)), int(random.below(29)));
            covered(place.x, place.y) = 1;
            picture(place.x, place.y) = {std::uint8_t(place.x), std::uint8_t(place.y), 255};
            sources.push_back(place);
        }
        dilate(picture, covered);
        const auto squared = [](glm::ivec2 way) { return way.x * way.x + way.y * way.y; };
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                int nearest = 1 << 20;
                for (const glm::ivec2 source : sources)
                    nearest = std::min(nearest, squared(source - glm::ivec2(x, y)));
                const glm::u8vec3& pixel = picture(x, y);
                EXPECT_EQ(squared(glm::ivec2(pixel.r, pixel.g) - glm::ivec2(x, y)), nearest) << x << ' ' << y;
            }
    }
}

TEST(Dilate, LeavesAPictureOfNothingAlone) {
    ByteImage picture(5, 4, glm::u8vec3(9));
    dilate(picture, Image<std::uint8_t>(5, 4, 0));
    EXPECT_EQ(picture, ByteImage(5, 4, glm::u8vec3(9)));
}

TEST(VertexColors, AreOneAtAPlaceHoweverManyVerticesLieThere) {
    scene::Mesh mesh = scene::merged(
        {test::triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), test::triangle({1, 0, 0}, {1, 1, 0}, {0, 1, 0})});
    const auto colors = vertexColors(
        mesh, [](std::uint32_t face, glm::vec2) { return face == 0 ? glm::vec3(0) : glm::vec3(1, 0.5f, 0); });
    ASSERT_EQ(colors.size(), 6u);
    EXPECT_EQ(colors[0], glm::u8vec3(0));
    EXPECT_EQ(colors[4], glm::u8vec3(255, 128, 0));
    EXPECT_EQ(colors[1], colors[3]);  // both at (1, 0, 0), of two faces equally large
    EXPECT_NEAR(colors[1].r, 127.5, 1);
}

}  // namespace
}  // namespace chiaro::exporting
