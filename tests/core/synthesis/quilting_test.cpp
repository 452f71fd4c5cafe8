#include "core/synthesis/quilting.h"

#include "core/base/error.h"
#include "core/synthesis/block_grid.h"
#include "tests/core/synthesis/textures.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace chiaro::synthesis {
namespace {

using test::waves;

QuiltTask taskOf(const ColorImage& source, int width, int height) {
    QuiltTask task;
    task.source = &source;
    task.width = width;
    task.height = height;
    return task;
}

QuiltParams blocksOf(int block, int overlap = 0) {
    QuiltParams params;
    params.block = block;
    params.overlap = overlap;
    return params;
}

// Every pixel of a picture comes from where its origin says.
void expectTrueOrigins(const ColorImage& source, const QuiltResult& result) {
    for (int y = 0; y < result.texture.height(); ++y)
        for (int x = 0; x < result.texture.width(); ++x) {
            const glm::i16vec2 from = result.origin(x, y);
            ASSERT_GE(from.x, 0) << x << ' ' << y;
            ASSERT_EQ(result.texture(x, y), source(from.x, from.y));
        }
}

TEST(Quilting, AutomaticOverlapIsASixthOfTheBlock) {
    EXPECT_EQ(blocksOf(32).overlapPixels(), 5);
    EXPECT_EQ(blocksOf(48).overlapPixels(), 8);
    EXPECT_EQ(blocksOf(4).overlapPixels(), 2);
    EXPECT_EQ(blocksOf(32, 30).overlapPixels(), 16);
}

TEST(Quilting, FillsEveryPixelFromTheSource) {
    const ColorImage source = waves(70, 50, 1);
    for (const glm::ivec2 size : {glm::ivec2(64, 64), {37, 81}, {11, 9}, {1, 1}, {12, 100}}) {
        const QuiltResult result = quilt(taskOf(source, size.x, size.y), blocksOf(12));
        ASSERT_EQ(result.texture.width(), size.x);
        expectTrueOrigins(source, result);
    }
}

TEST(Quilting, CountsBlocksAndClipsTheLast) {
    const ColorImage source = waves(40, 40, 2);
    // Block 12, overlap 2: starts at 0, 10, 20; the last reaches past 30.
    const QuiltResult result = quilt(taskOf(source, 30, 32), blocksOf(12));
    ASSERT_EQ(result.blocks.size(), 9u);
    EXPECT_EQ(blockCount(taskOf(source, 30, 32), blocksOf(12)), 9u);
    EXPECT_EQ(blockCount(taskOf(source, 32, 32), blocksOf(12)), 9u);
    EXPECT_EQ(blockCount(taskOf(source, 33, 32), blocksOf(12)), 12u);
    EXPECT_EQ(result.blocks[8].site.position, glm::ivec2(20, 20));
    EXPECT_EQ(result.blocks[8].site.size, glm::ivec2(10, 12));
    EXPECT_EQ(result.report().blocks, 9u);
    EXPECT_EQ(result.blocks[4].overlapPixels, 12u * 2 + 10 * 2);
}

TEST(Quilting, ContinuesTheSourceWhereThatFitsExactly) {
    // Without tolerance the one best block is the one that continues its neighbour.
    const ColorImage source = test::exactNoise(80, 80, 3);
    QuiltTask task = taskOf(source, 40, 40);
    task.candidates = [](const BlockSite& site) {
        return site.index == 0 ? CandidateArea{5, 7, 1, 1} : CandidateArea{0, 0, 65, 65};
    };
    QuiltParams params = blocksOf(16, 4);
    params.tolerance = 0;
    const QuiltResult result = quilt(task, params);
    EXPECT_EQ(result.report().overlapError, 0);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) ASSERT_EQ(result.origin(x, y), glm::i16vec2(x + 5, y + 7));
}

TEST(Quilting, OverlapErrorIsTheMeanSquaredDifference) {
    // A source of two flat halves and candidates that force one of each: |difference|^2 = 3 * 0.5^2.
    ColorImage source(16, 8, glm::vec3(0.25f));
    for (int y = 0; y < 8; ++y)
        for (int x = 8; x < 16; ++x) source(x, y) = glm::vec3(-0.25f);
    QuiltTask task = taskOf(source, 14, 8);
    task.candidates = [](const BlockSite& site) { return CandidateArea{8 * site.index, 0, 1, 1}; };
    const QuiltResult result = quilt(task, blocksOf(8, 2));
    EXPECT_EQ(result.blocks.size(), 2u);
    EXPECT_DOUBLE_EQ(result.report().overlapError, 0.75);
}

TEST(Quilting, SameBytesForAnyNumberOfThreads) {
    const ColorImage source = waves(90, 60, 4);
    for (const bool wrap : {false, true}) {
        QuiltTask task = taskOf(source, 150, 130);
        task.wrap = wrap;
        task.variety = 3;
        QuiltResult results[2];
        for (const std::size_t threads : {1, 8}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            results[threads / 8] = quilt(task, blocksOf(16));
        }
        EXPECT_EQ(results[0].texture, results[1].texture);
        EXPECT_EQ(results[0].origin, results[1].origin);
        EXPECT_EQ(results[0].report().overlapError, results[1].report().overlapError);
    }
}

TEST(Quilting, SameBytesOnAnyProcessor) {
    const ColorImage source = waves(70, 60, 5);
    std::vector<ColorImage> pictures;
    for (const char* target : kernels::supportedTargets()) {
        kernels::onlyUseTarget(target);
        pictures.push_back(quilt(taskOf(source, 100, 90), blocksOf(20)).texture);
    }
    kernels::onlyUseTarget(nullptr);
    for (const ColorImage& picture : pictures) EXPECT_EQ(picture, pictures.front());
}

TEST(Quilting, TheSeedDecides) {
    const ColorImage source = waves(70, 60, 6);
    QuiltParams params = blocksOf(16);
    const QuiltResult first = quilt(taskOf(source, 60, 60), params);
    EXPECT_EQ(quilt(taskOf(source, 60, 60), params).texture, first.texture);
    params.seed = 2;
    EXPECT_NE(quilt(taskOf(source, 60, 60), params).texture, first.texture);
}

TEST(Quilting, InvalidPixelsAreNeverMadeAndNeverCount) {
    const ColorImage source = waves(60, 50, 7);
    PixelMask disc(90, 80, 0);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 90; ++x) disc(x, y) = (x - 45) * (x - 45) + (y - 40) * (y - 40) < 900;
    QuiltTask task = taskOf(source, 90, 80);
    task.valid = &disc;
    const QuiltResult result = quilt(task, blocksOf(12));
    EXPECT_LT(result.blocks.size(), blockCount(task, blocksOf(12)));
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 90; ++x) {
            ASSERT_EQ(result.origin(x, y).x >= 0, disc(x, y) != 0);
            ASSERT_TRUE(disc(x, y) || result.texture(x, y) == glm::vec3(0));
        }
    // Each block's overlap was counted over valid pixels alone.
    for (const PlacedBlock& block : result.blocks) {
        std::size_t valid = 0;
        for (int y = 0; y < block.site.size.y; ++y)
            for (int x = 0; x < block.site.size.x; ++x)
                valid += disc(block.site.position.x + x, block.site.position.y + y);
        EXPECT_LT(block.overlapPixels, valid);
    }
    EXPECT_TRUE(quilt(task, blocksOf(12)).texture == result.texture);
}

TEST(Quilting, NothingValidMakesNothing) {
    const ColorImage source = waves(40, 40, 8);
    const PixelMask nothing(50, 50, 0);
    QuiltTask task = taskOf(source, 50, 50);
    task.valid = &nothing;
    EXPECT_EQ(quilt(task, blocksOf(12)).report().blocks, 0u);
}

TEST(Quilting, ContinuesWhatIsFilled) {
    // The left third is the source itself, so the one exact continuation is the rest of the source.
    const ColorImage source = test::exactNoise(56, 36, 9);
    PixelMask where(56, 36, 0);
    for (int y = 0; y < 36; ++y)
        for (int x = 0; x < 20; ++x) where(x, y) = 1;
    QuiltTask task = taskOf(source, 56, 36);
    task.filled = &source;
    task.filledWhere = &where;
    QuiltParams params = blocksOf(16, 6);
    params.tolerance = 0;
    const QuiltResult result = quilt(task, params);
    EXPECT_EQ(result.texture, source);
    EXPECT_EQ(result.origin(3, 3), glm::i16vec2(-1));
    EXPECT_EQ(result.origin(50, 30), glm::i16vec2(50, 30));
}

TEST(Quilting, KeepsFilledPixelsAwayFromTheirEdge) {
    const ColorImage source = waves(60, 60, 10);
    const ColorImage paint(64, 64, glm::vec3(0.4f, -0.2f, 0.1f));
    PixelMask where(64, 64, 0);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) where(x, y) = std::abs(x - 30) + std::abs(y - 34) < 22;
    QuiltTask task = taskOf(source, 64, 64);
    task.filled = &paint;
    task.filledWhere = &where;
    const QuiltResult result = quilt(task, blocksOf(16, 4));
    int kept = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const bool deep = std::abs(x - 30) + std::abs(y - 34) < 12;
            ASSERT_TRUE(!deep || result.texture(x, y) == paint(x, y));
            kept += result.origin(x, y).x < 0;
        }
    EXPECT_GT(kept, 500);
}

TEST(Quilting, StaysCloseToThePreviousPicture) {
    const ColorImage source = waves(90, 90, 11), previous = waves(64, 64, 12);
    const auto distance = [&](double weight, const PixelMask* where) {
        QuiltTask task = taskOf(source, 64, 64);
        task.previous = &previous;
        task.previousWhere = where;
        task.previousWeight = weight;
        const QuiltResult result = quilt(task, blocksOf(16));
        double sum = 0;
        for (std::size_t i = 0; i < previous.pixelCount(); ++i) {
            const glm::vec3 difference = result.texture.pixels()[i] - previous.pixels()[i];
            sum += double(glm::dot(difference, difference));
        }
        return sum;
    };
    const PixelMask nowhere(64, 64, 0);
    const double apart = distance(0, nullptr);
    EXPECT_LT(distance(1, nullptr), 0.5 * apart);
    EXPECT_LT(distance(10, nullptr), distance(0.1, nullptr));
    EXPECT_EQ(distance(10, &nowhere), apart);
}

TEST(Quilting, UsesOnlyTheCandidatesGiven) {
    // Columns tell where they came from.
    const ColorImage source = waves(100, 40, 13);
    QuiltTask task = taskOf(source, 80, 60);
    task.candidates = [](const BlockSite& site) { return CandidateArea{site.position.x / 2, 3, 10, 12}; };
    const QuiltResult result = quilt(task, blocksOf(16));
    for (const PlacedBlock& block : result.blocks) {
        EXPECT_GE(block.source.x, block.site.position.x / 2);
        EXPECT_LT(block.source.x, block.site.position.x / 2 + 10);
        EXPECT_TRUE(block.source.y >= 3 && block.source.y < 15);
    }
}

TEST(Quilting, VarietyKeepsPlacesApart) {
    // A source hardly larger than its blocks: without variety the few best places come back all the time.
    const ColorImage source = waves(26, 40, 17);
    const auto repeats = [&](int variety) {
        QuiltTask task = taskOf(source, 150, 150);
        task.wrap = true;
        task.variety = variety;
        QuiltParams params = blocksOf(16);
        params.tolerance = 0;
        const QuiltResult result = quilt(task, params);
        const BlockGrid grid(150, 150, 16, params.overlapPixels(), true);
        int count = 0;
        for (const PlacedBlock& block : result.blocks)
            for (const int other : grid.earlier(block.site.index, 3))
                count += block.source == result.blocks[std::size_t(other)].source;
        return count;
    };
    EXPECT_GT(repeats(0), 3);
    EXPECT_EQ(repeats(3), 0);
}

TEST(BlockGrid, KnowsWhatIsInPlace) {
    // 4 x 3 blocks: before block (1, 1) come the first row up to column 2 and its left neighbour.
    const BlockGrid grid(42, 32, 12, 2, false);
    ASSERT_EQ(grid.count(), 12);
    EXPECT_EQ(grid.earlier(5, 1), (std::vector<int>{0, 1, 2, 4}));
    EXPECT_EQ(grid.earlier(5, 9), (std::vector<int>{0, 1, 2, 4}));
    EXPECT_EQ(grid.earlier(10, 1), (std::vector<int>{5, 6, 7, 9}));
    EXPECT_EQ(grid.earlier(10, 2), (std::vector<int>{5, 6, 7, 9, 0, 1, 2, 3, 4, 8}));
    EXPECT_TRUE(grid.earlier(0, 5).empty());
    EXPECT_TRUE(grid.earlier(5, 0).empty());
}

TEST(BlockGrid, WaitsForWhatItOverlaps) {
    const BlockGrid grid(42, 32, 12, 2, false);
    const auto successors = grid.successors();
    EXPECT_EQ(successors[0], (std::vector<int>{1, 4, 5}));
    EXPECT_EQ(successors[5], (std::vector<int>{6, 8, 9, 10}));
    EXPECT_TRUE(successors[11].empty());
    // A ring of five: the last column meets the first of its own row, of the row above and of the row below.
    const BlockGrid ring(50, 50, 12, 2, true);
    const auto around = ring.successors();
    EXPECT_EQ(ring.count(), 25);
    EXPECT_EQ(around[0], (std::vector<int>{1, 4, 5, 6, 9, 20, 21, 24}));
}

TEST(Quilting, ConstantTextureStaysConstant) {
    const ColorImage source(50, 40, glm::vec3(0.1f, 0.2f, -0.3f));
    const QuiltResult result = quilt(taskOf(source, 70, 70), blocksOf(16));
    EXPECT_EQ(result.texture, ColorImage(70, 70, glm::vec3(0.1f, 0.2f, -0.3f)));
    EXPECT_EQ(result.report().overlapError, 0);
}

TEST(Quilting, BlocksThatDoNotFitAreMadeSmaller) {
    const ColorImage small = waves(20, 9, 14), single(1, 1, glm::vec3(0.5f));
    EXPECT_EQ(fittedBlock(blocksOf(32), taskOf(small, 50, 50)).block, 6);
    EXPECT_EQ(fittedBlock(blocksOf(9), taskOf(small, 50, 50)).block, 9);
    expectTrueOrigins(small, quilt(taskOf(small, 50, 50), blocksOf(32)));
    expectTrueOrigins(single, quilt(taskOf(single, 5, 4), blocksOf(4)));
    QuiltTask wrapped = taskOf(small, 7, 5);
    wrapped.wrap = true;
    expectTrueOrigins(small, quilt(wrapped, blocksOf(256)));
}

TEST(Quilting, RefusesNothingToQuiltFrom) {
    const ColorImage empty;
    EXPECT_THROW(quilt(taskOf(empty, 5, 5), blocksOf(4)), Error);
    EXPECT_THROW(quilt(QuiltTask(), blocksOf(4)), Error);
}

TEST(Quilting, StopsWhenCancelled) {
    const ColorImage source = waves(60, 60, 15);
    std::stop_source stop;
    int reports = 0;
    const Task task(stop.get_token(), [&](double) {
        if (++reports == 3) stop.request_stop();
    });
    EXPECT_THROW(quilt(taskOf(source, 400, 400), blocksOf(16), task), Cancelled);
    EXPECT_LT(reports, 40);
}

TEST(Quilting, ReportsItsProgressToTheEnd) {
    const ColorImage source = waves(60, 60, 16);
    double last = 0;
    const Task task(std::stop_token(), [&](double fraction) {
        EXPECT_GT(fraction, last);
        last = fraction;
    });
    quilt(taskOf(source, 100, 100), blocksOf(16), task);
    EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace chiaro::synthesis
