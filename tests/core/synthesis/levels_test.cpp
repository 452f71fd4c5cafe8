#include "core/synthesis/levels.h"

#include "core/base/error.h"
#include "core/gradient/gradient.h"
#include "core/sample/strip.h"
#include "core/synthesis/tiling.h"
#include "tests/core/synthesis/textures.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

namespace chiaro::synthesis {
namespace {

// A strip from dark to light with a texture of its own, and its gradient.
struct Paint {
    ColorImage strip;
    std::vector<glm::vec3> gradient;
};

Paint paintOf(int width, int height) {
    Paint paint{test::waves(width, height, 1), {}};
    for (int x = 0; x < width; ++x)
        paint.gradient.push_back(glm::vec3(0.2f, 0.25f, 0.3f) + 0.5f * float(x) / float(width - 1));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            paint.strip(x, y) =
                glm::clamp(0.3f * paint.strip(x, y) + paint.gradient[std::size_t(x)], 0.0f, 1.0f);
    return paint;
}

LevelParams levelsOf(int count, int size, Tiling tiling) {
    LevelParams params;
    params.count = count;
    params.size = size;
    params.tiling = tiling;
    return params;
}

float difference(const glm::vec3& a, const glm::vec3& b) {
    return glm::dot(a - b, a - b);
}

// Mean squared step between neighbours across the picture's border, relative to that inside.
double seamContrast(const ColorImage& level) {
    const int n = level.width();
    double inside = 0, across = 0;
    for (int i = 0; i < n; ++i) {
        across += double(difference(level(n - 1, i), level(0, i)) + difference(level(i, n - 1), level(i, 0)));
        for (int j = 1; j < n; ++j)
            inside +=
                double(difference(level(j - 1, i), level(j, i)) + difference(level(i, j - 1), level(i, j)));
    }
    return across / (inside / (n - 1));
}

TEST(TilingMask, MatchesTheFormulaByHand) {
    // n = 4: pixel centres are sqrt(0.5), sqrt(2.5) or sqrt(4.5) from the middle, n/2 = 2.
    ColorImage texture(4, 4, glm::vec3(0));
    texture(1, 1) = glm::vec3(1);
    const ColorImage tiled = tiledByMask(texture);
    const float inner = 255 - 255 * std::sqrt(0.5f) / 2, outer = 1;  // sqrt(4.5) / 2 > 1 clips to 1
    EXPECT_NEAR(tiled(1, 1).r, inner / (inner + outer), 1e-6);       // rolled: (3, 3)
    EXPECT_NEAR(tiled(3, 3).r, inner / (inner + outer), 1e-6);
    EXPECT_EQ(tiled(2, 2).r, 0);
    EXPECT_EQ(tiled(1, 2).r, 0);
}

TEST(TilingMask, KeepsAConstant) {
    const ColorImage texture(16, 16, glm::vec3(0.25f, -0.5f, 0.125f));
    const ColorImage tiled = tiledByMask(texture);
    for (const glm::vec3& color : tiled.pixels()) EXPECT_LT(difference(color, texture(0, 0)), 1e-12f);
}

TEST(Levels, AreAsManyAndAsLargeAsAsked) {
    const Paint paint = paintOf(320, 60);
    const LevelStack stack = makeLevels(paint.strip, paint.gradient, levelsOf(5, 96, Tiling::Seam));
    ASSERT_EQ(stack.levels.size(), 5u);
    for (const ColorImage& level : stack.levels) {
        EXPECT_EQ(level.width(), 96);
        EXPECT_EQ(level.height(), 96);
    }
    EXPECT_GE(stack.report.blocks, 5u * 4 * 4);
    EXPECT_GT(stack.report.overlapError, 0);
}

TEST(Levels, TileWithoutASeam) {
    const ColorImage strip = sample::makeStrip(sample::readScan(test::resource("demo/samples/oil.png")));
    const gradient::Separation separation = gradient::separate(strip);
    const auto contrast = [&](Tiling tiling) {
        double sum = 0;
        for (const ColorImage& level :
             makeLevels(strip, separation.gradient, levelsOf(4, 256, tiling)).levels)
            sum += seamContrast(level) / 4;
        return sum;
    };
    EXPECT_LT(contrast(Tiling::Seam), 1.2);
    EXPECT_LT(contrast(Tiling::Mask), 1.6);  // the mask softens the inside more than the border
    // The measure does tell: a quilt that doesn't wrap shows its border.
    QuiltTask task;
    task.source = &separation.texture;
    task.width = task.height = 256;
    EXPECT_GT(seamContrast(quilt(task, {}).texture), 2);
}

TEST(Levels, SeamTilingDoesNotBlur) {
    const Paint paint = paintOf(400, 80);
    LevelParams params = levelsOf(2, 128, Tiling::Seam);
    // Every pixel of a seam level is a pixel of the strip's texture.
    const ColorImage level = makeLevels(paint.strip, paint.gradient, params).levels[0];
    std::vector<float> reds;
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 400; ++x) reds.push_back(paint.strip(x, y).r - paint.gradient[std::size_t(x)].r);
    std::ranges::sort(reds);
    for (const glm::vec3& color : level.pixels()) ASSERT_TRUE(std::ranges::binary_search(reds, color.r));
}

TEST(Levels, ComeFromTheirOwnSection) {
    // Each section of the strip has a colour of its own.
    ColorImage strip(400, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 400; ++x) strip(x, y) = glm::vec3(float(x / 100) / 10, 0.5f, 0.5f);
    const std::vector<glm::vec3> gradient(400, glm::vec3(0));
    const LevelStack stack = makeLevels(strip, gradient, levelsOf(4, 64, Tiling::Seam));
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(stack.levels[std::size_t(i)], ColorImage(64, 64, glm::vec3(float(i) / 10, 0.5f, 0.5f)));
}

TEST(Levels, SectionBaseTakesTheSectionsMeanOff) {
    const Paint paint = paintOf(400, 80);
    LevelParams params = levelsOf(4, 128, Tiling::Seam);
    params.base = LevelBase::Section;
    for (const ColorImage& level : makeLevels(paint.strip, paint.gradient, params).levels) {
        glm::dvec3 sum(0);
        for (const glm::vec3& color : level.pixels()) sum += glm::dvec3(color);
        EXPECT_LT(glm::length(sum / double(level.pixelCount())), 0.08);
    }
}

TEST(Levels, MeansDoNotDrift) {
    const Paint paint = paintOf(640, 100);
    for (const ColorImage& level :
         makeLevels(paint.strip, paint.gradient, levelsOf(8, 256, Tiling::Seam)).levels) {
        glm::dvec3 sum(0);
        for (const glm::vec3& color : level.pixels()) sum += glm::dvec3(color);
        EXPECT_LT(glm::length(sum / double(level.pixelCount())), 0.03);
    }
}

TEST(Levels, NarrowSectionsAndSmallStripsStillWork) {
    for (const glm::ivec2 size : {glm::ivec2(64, 16), {64, 200}, {563, 20}, {100, 33}})
        for (const Tiling tiling : {Tiling::Mask, Tiling::Seam}) {
            const Paint paint = paintOf(size.x, size.y);
            const LevelStack stack = makeLevels(paint.strip, paint.gradient, levelsOf(32, 64, tiling));
            ASSERT_EQ(stack.levels.size(), 32u);
            for (const ColorImage& level : stack.levels)
                for (const glm::vec3& color : level.pixels()) ASSERT_LT(glm::length(color), 1);
        }
}

TEST(Levels, LargeBlocksStillWork) {
    const Paint paint = paintOf(300, 80);
    LevelParams params = levelsOf(2, 64, Tiling::Seam);
    params.quilt.block = 256;
    EXPECT_EQ(makeLevels(paint.strip, paint.gradient, params).levels[0].width(), 64);
}

TEST(Levels, SameBytesForAnyNumberOfThreads) {
    const Paint paint = paintOf(300, 60);
    std::vector<LevelStack> stacks;
    for (const std::size_t threads : {1, 8}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        stacks.push_back(makeLevels(paint.strip, paint.gradient, levelsOf(4, 100, Tiling::Seam)));
    }
    EXPECT_EQ(stacks[0].levels, stacks[1].levels);
    EXPECT_EQ(stacks[0].report.overlapError, stacks[1].report.overlapError);
}

TEST(Levels, LevelsOfOneTextureDiffer) {
    const ColorImage strip(128, 64, glm::vec3(0.5f));
    ColorImage noisy = test::waves(128, 64, 3);
    const std::vector<glm::vec3> gradient(128, glm::vec3(0));
    const LevelStack stack = makeLevels(noisy, gradient, levelsOf(2, 64, Tiling::Seam));
    EXPECT_NE(stack.levels[0], stack.levels[1]);
    EXPECT_EQ(makeLevels(strip, gradient, levelsOf(2, 64, Tiling::Seam)).levels[0],
              ColorImage(64, 64, glm::vec3(0.5f)));
}

TEST(Levels, RealStripsTileAndKeepTheirContrast) {
    CHIARO_NEEDS_SHARED_DATA();
    for (const char* name : {"wc_green_21.png", "charcoal_mass_gray.png", "oil_jungfrau.png"}) {
        const ColorImage strip = sample::makeStrip(sample::readScan(test::sharedData() / "samples" / name));
        const gradient::Separation separation = gradient::separate(strip);
        const LevelStack stack = makeLevels(strip, separation.gradient, levelsOf(8, 256, Tiling::Seam));
        double seam = 0, level = 0, texture = 0;
        for (const ColorImage& slice : stack.levels) {
            seam += seamContrast(slice) / 8;
            for (const glm::vec3& color : slice.pixels())
                level += double(glm::dot(color, color)) / (8 * double(slice.pixelCount()));
        }
        for (const glm::vec3& color : separation.texture.pixels())
            texture += double(glm::dot(color, color)) / double(separation.texture.pixelCount());
        EXPECT_LT(seam, 1.15) << name;
        EXPECT_NEAR(level / texture, 1, 0.25) << name;
    }
}

TEST(Levels, RefuseWhatTheyCannotUse) {
    const Paint paint = paintOf(100, 40);
    EXPECT_THROW(makeLevels({}, {}, {}), Error);
    EXPECT_THROW(makeLevels(paint.strip, {glm::vec3(0)}, {}), Error);
    LevelParams params = levelsOf(33, 64, Tiling::Seam);
    EXPECT_THROW(makeLevels(paint.strip, paint.gradient, params), Error);
    params = levelsOf(8, 63, Tiling::Seam);
    EXPECT_THROW(makeLevels(paint.strip, paint.gradient, params), Error);
    params = levelsOf(8, 64, Tiling::Seam);
    params.quilt.block = 3;
    EXPECT_THROW(makeLevels(paint.strip, paint.gradient, params), Error);
}

TEST(Levels, StopWhenCancelled) {
    const Paint paint = paintOf(300, 60);
    std::stop_source stop;
    const Task task(stop.get_token(), [&](double) { stop.request_stop(); });
    EXPECT_THROW(makeLevels(paint.strip, paint.gradient, levelsOf(8, 512, Tiling::Seam), task), Cancelled);
}

}  // namespace
}  // namespace chiaro::synthesis
