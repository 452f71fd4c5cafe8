#include "core/synthesis/block_search.h"

#include "tests/core/synthesis/textures.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace chiaro::synthesis {
namespace {

using test::exactNoise;

using Counts = std::function<bool(int x, int y)>;

// A template cut out of a picture.
SearchTemplate cutOut(const SearchTexture& source, const ColorImage& picture, glm::ivec2 corner, int side,
                      const Counts& counts) {
    SearchTemplate goal{Image<SearchPixel>(side, side), 1};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            goal.pixels(x, y) = source.rounded(picture(corner.x + x, corner.y + y));
            goal.pixels(x, y).counts = counts(x, y);
        }
    return goal;
}

// The sum of squared differences in float, straight from its definition.
double bruteForce(const ColorImage& source, glm::ivec2 position, const ColorImage& picture, glm::ivec2 corner,
                  int side, const Counts& counts) {
    double sum = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            if (!counts(x, y)) continue;
            const glm::dvec3 difference = glm::dvec3(source(position.x + x, position.y + y)) -
                                          glm::dvec3(picture(corner.x + x, corner.y + y));
            sum += glm::dot(difference, difference);
        }
    return sum;
}

CandidateArea everywhere(const ColorImage& source, int side) {
    return {0, 0, source.width() - side + 1, source.height() - side + 1};
}

glm::ivec2 find(const ColorImage& source, const SearchTemplate& goal, double tolerance = 0,
                std::uint64_t seed = 1) {
    SearchMemory memory;
    return findBlock(SearchTexture(source),
                     {{&goal, 1}, everywhere(source, goal.pixels.width()), {}, tolerance}, Random(seed),
                     memory)
        .position;
}

bool all(int, int) {
    return true;
}

TEST(BlockSearch, FindsABlockAtEveryPositionThereIs) {
    // Sizes that are no multiple of any vector; the last column and row are among the positions.
    const ColorImage source = exactNoise(43, 29, 1);
    const SearchTexture prepared(source);
    const int side = 9;
    for (int y = 0; y + side <= source.height(); ++y)
        for (int x = 0; x + side <= source.width(); ++x)
            ASSERT_EQ(find(source, cutOut(prepared, source, {x, y}, side, all)), glm::ivec2(x, y));
}

TEST(BlockSearch, AgreesWithBruteForceForAnyMask) {
    const ColorImage source = exactNoise(37, 31, 2), picture = exactNoise(40, 40, 3);
    const SearchTexture prepared(source);
    const int side = 12;
    Image<std::uint8_t> random(side, side);
    Random numbers(4);
    for (std::uint8_t& value : random.pixels()) value = std::uint8_t(numbers.below(2));
    const std::vector<Counts> masks{
        all,
        [](int x, int) { return x < 3; },                                        // left
        [](int, int y) { return y < 2; },                                        // top
        [](int x, int y) { return x < 3 || y < 3; },                             // both
        [](int x, int y) { return x < 2 || y < 2 || x > 9 || y > 9; },           // a frame
        [&](int x, int y) { return random(x, y) != 0; },                         // anything
        [](int x, int y) { return x == 11 && y == 11; },                         // the last pixel alone
        [](int x, int y) { return (x - 6) * (x - 6) + (y - 6) * (y - 6) < 20; }  // a disc
    };
    for (std::size_t i = 0; i < masks.size(); ++i) {
        const glm::ivec2 corner(5 + int(i), 7);
        double best = std::numeric_limits<double>::max();
        for (int y = 0; y + side <= source.height(); ++y)
            for (int x = 0; x + side <= source.width(); ++x)
                best = std::min(best, bruteForce(source, {x, y}, picture, corner, side, masks[i]));
        const glm::ivec2 found = find(source, cutOut(prepared, picture, corner, side, masks[i]));
        EXPECT_NEAR(bruteForce(source, found, picture, corner, side, masks[i]), best, 1e-6) << "mask " << i;
    }
}

TEST(BlockSearch, StaysInsideTheCandidates) {
    const ColorImage source = exactNoise(40, 30, 5);
    const SearchTexture prepared(source);
    SearchMemory memory;
    const CandidateArea area{7, 11, 3, 2};
    const SearchTemplate elsewhere = cutOut(prepared, source, {20, 3}, 8, all);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const glm::ivec2 found =
            findBlock(prepared, {{&elsewhere, 1}, area, {}, 10}, Random(seed), memory).position;
        EXPECT_TRUE(found.x >= 7 && found.x < 10 && found.y >= 11 && found.y < 13);
    }
}

TEST(BlockSearch, PicksAmongAllThatAreGoodEnough) {
    // A column of grey values: the error of candidate y against 0 is (y / 63)^2 in each channel and pixel.
    ColorImage source(4, 127);
    for (int y = 0; y < 127; ++y)
        for (int x = 0; x < 4; ++x) source(x, y) = glm::vec3(float(y - 63) / 63);
    ColorImage goalColor(4, 4, glm::vec3(10.0f / 63));
    SearchTexture prepared(source);
    SearchTemplate goal = cutOut(prepared, goalColor, {0, 0}, 4, [](int, int y) { return y == 0; });
    SearchMemory memory;
    const auto choices = [&](double tolerance, CandidateArea area) {
        return findBlock(prepared, {{&goal, 1}, area, {}, tolerance}, Random(1), memory).choices;
    };
    EXPECT_EQ(choices(0.1, {0, 0, 1, 124}), 1u);   // the exact one: nothing is within 10% of 0
    EXPECT_EQ(choices(0.0, {0, 75, 1, 49}), 1u);   // from an error of 2 steps upwards
    EXPECT_EQ(choices(1.24, {0, 75, 1, 49}), 1u);  // 3 steps: 9 / 4 = 2.25 times as much
    EXPECT_EQ(choices(1.26, {0, 75, 1, 49}), 2u);
    EXPECT_EQ(choices(3.0, {0, 75, 1, 49}), 3u);  // up to 4 steps
}

TEST(BlockSearch, PicksEachOfEqualCandidates) {
    const ColorImage source(12, 10, glm::vec3(0.25f));
    const SearchTexture prepared(source);
    const SearchTemplate goal = cutOut(prepared, source, {0, 0}, 8, all);
    SearchMemory memory;
    Image<int> hits(5, 3, 0);
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        const BlockMatch match =
            findBlock(prepared, {{&goal, 1}, everywhere(source, 8), {}, 0.1}, Random(seed), memory);
        EXPECT_EQ(match.choices, 15u);
        ++hits(match.position.x, match.position.y);
    }
    for (const int count : hits.pixels()) EXPECT_NEAR(count, 40, 30);
}

TEST(BlockSearch, LeavesOutWhatIsExcluded) {
    const ColorImage source = exactNoise(40, 30, 5);
    const SearchTexture prepared(source);
    SearchMemory memory;
    const SearchTemplate goal = cutOut(prepared, source, {20, 3}, 8, all);
    const std::vector<CandidateArea> excluded{{19, 2, 3, 3}};
    const auto found = [&](std::span<const CandidateArea> areas, const std::vector<SearchTemplate>& goals) {
        return findBlock(prepared, {goals, everywhere(source, 8), areas, 0}, Random(1), memory).position;
    };
    EXPECT_EQ(found({}, {goal}), glm::ivec2(20, 3));
    EXPECT_NE(found(excluded, {goal}), glm::ivec2(20, 3));
    EXPECT_EQ(found(excluded, {goal, goal}), found(excluded, {goal}));
}

TEST(BlockSearch, ExcludesHalfOfTheCandidatesAtMost) {
    const std::vector<glm::ivec2> used{{5, 5}, {2, 9}, {7, 5}, {90, 90}};
    // 100 candidates, 4 places: squares of 3 x 3, since 4 of 5 x 5 are more than 50.
    const auto excluded = excludedAround(used, {0, 0, 10, 10}, 32);
    EXPECT_EQ(excluded, (std::vector<CandidateArea>{{4, 4, 3, 3}, {1, 8, 3, 2}, {6, 4, 3, 3}}));
    EXPECT_EQ(excludedAround(used, {5, 5, 2, 1}, 32), (std::vector<CandidateArea>{{5, 5, 1, 1}}));
    EXPECT_TRUE(excludedAround(used, {5, 5, 1, 1}, 32).empty());
    EXPECT_TRUE(excludedAround({}, {0, 0, 10, 10}, 32).empty());
    // A quarter of a block to each side, however many candidates there are.
    EXPECT_EQ(excludedAround({&used[0], 1}, {0, 0, 100, 100}, 8), (std::vector<CandidateArea>{{3, 3, 5, 5}}));
}

TEST(BlockSearch, WeighsSeveralTemplates) {
    const ColorImage source = exactNoise(30, 30, 6);
    const SearchTexture prepared(source);
    std::vector<SearchTemplate> goals{cutOut(prepared, source, {3, 4}, 8, [](int x, int) { return x < 2; }),
                                      cutOut(prepared, source, {15, 16}, 8, all)};
    SearchMemory memory;
    const auto found = [&](double weight) {
        goals[1].weight = weight;
        return findBlock(prepared, {goals, everywhere(source, 8), {}, 0}, Random(1), memory).position;
    };
    EXPECT_EQ(found(0), glm::ivec2(3, 4));
    EXPECT_EQ(found(1.0 / 512), glm::ivec2(3, 4));
    EXPECT_EQ(found(4), glm::ivec2(15, 16));
}

TEST(BlockSearch, AnyCandidateWithoutAPixelToMatch) {
    const ColorImage source = exactNoise(20, 20, 7);
    const SearchTemplate nothing =
        cutOut(SearchTexture(source), source, {0, 0}, 8, [](int, int) { return false; });
    EXPECT_NE(find(source, nothing, 0.1, 1), find(source, nothing, 0.1, 2));
}

// A draft of the block that a picture goes on with, sought everywhere in the source.
BlockMatch findDraft(const SearchTexture& source, const std::vector<SearchTemplate>& goals,
                     std::span<const CandidateArea> excluded = {}, double tolerance = 0,
                     std::uint64_t seed = 1) {
    const int side = goals[0].pixels.width();
    const CandidateArea area{0, 0, source.width() - side + 1, source.height() - side + 1};
    SearchMemory memory;
    return findBlock(source, {goals, area, excluded, tolerance, true}, Random(seed), memory);
}

TEST(DraftSearch, FindsABlockAtEveryPositionOfPatches) {
    const ColorImage noise = exactNoise(15, 12, 1);
    ColorImage source(75, 60);
    for (int y = 0; y < source.height(); ++y)
        for (int x = 0; x < source.width(); ++x) source(x, y) = noise(x / 5, y / 5);
    const SearchTexture prepared(source);
    for (int y = 0; y + 11 <= source.height(); y += 3)
        for (int x = 0; x + 11 <= source.width(); ++x)
            ASSERT_EQ(findDraft(prepared, {cutOut(prepared, source, {x, y}, 11, all)}).position,
                      glm::ivec2(x, y));
}

TEST(DraftSearch, StaysInsideTheCandidatesAndOutOfTheExcluded) {
    const ColorImage source = test::waves(90, 70, 2);
    const SearchTexture prepared(source);
    const SearchTemplate goal = cutOut(prepared, source, {40, 33}, 8, all);
    const CandidateArea area{21, 13, 39, 41}, excluded{33, 20, 17, 19};
    SearchMemory memory;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const glm::ivec2 found =
            findBlock(prepared, {{&goal, 1}, area, {&excluded, 1}, 2, true}, Random(seed), memory).position;
        EXPECT_TRUE(found.x >= 21 && found.x < 60 && found.y >= 13 && found.y < 54);
        EXPECT_FALSE(found.x >= 33 && found.x < 50 && found.y >= 20 && found.y < 39);
    }
}

TEST(DraftSearch, WeighsSeveralTemplates) {
    const ColorImage source = test::waves(60, 60, 3);
    const SearchTexture prepared(source);
    std::vector<SearchTemplate> goals{cutOut(prepared, source, {3, 4}, 8, [](int x, int) { return x < 3; }),
                                      cutOut(prepared, source, {35, 26}, 8, all)};
    goals[1].weight = 0;
    EXPECT_EQ(findDraft(prepared, goals).position, glm::ivec2(3, 4));
    goals[1].weight = 4;
    EXPECT_EQ(findDraft(prepared, goals).position, glm::ivec2(35, 26));
}

TEST(DraftSearch, IsExactWhereThereAreFewCandidates) {
    const ColorImage source = exactNoise(40, 30, 5), picture = exactNoise(20, 20, 6);
    const SearchTexture prepared(source);
    SearchMemory memory;
    // The lattice of the half has 5 x 4 places, none, and none.
    for (const CandidateArea& area : {CandidateArea{7, 11, 11, 8}, {7, 3, 1, 9}, {7, 11, 1, 1}})
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const SearchTemplate goal = cutOut(prepared, picture, {int(seed) % 9, 3}, 8, all);
            SearchQuery query{{&goal, 1}, area, {}, 0.1, false};
            const glm::ivec2 exact = findBlock(prepared, query, Random(seed), memory).position;
            query.draft = true;
            EXPECT_EQ(findBlock(prepared, query, Random(seed), memory).position, exact);
        }
}

TEST(DraftSearch, AnyCandidateWithoutAPixelToMatchAndEachOfEqualOnes) {
    const ColorImage flat(60, 50, glm::vec3(0.25f));
    const SearchTexture prepared(flat);
    const SearchTemplate nothing = cutOut(prepared, flat, {0, 0}, 8, [](int, int) { return false; });
    EXPECT_EQ(findDraft(prepared, {nothing}).choices, 53u * 43u);
    const SearchTemplate goal = cutOut(prepared, flat, {0, 0}, 8, all);
    EXPECT_GT(findDraft(prepared, {goal}).choices, 1u);
    EXPECT_NE(findDraft(prepared, {goal}, {}, 0, 1).position, findDraft(prepared, {goal}, {}, 0, 2).position);
}

TEST(DraftSearch, EveryInstructionSetFindsTheSame) {
    const ColorImage source = test::waves(83, 71, 8), picture = test::waves(64, 64, 9);
    const SearchTexture prepared(source);
    const auto positions = [&] {
        std::vector<glm::ivec2> found;
        for (int i = 0; i < 8; ++i)
            found.push_back(findDraft(prepared,
                                      {cutOut(prepared, picture, {3 * i, 2 * i}, 12 + i,
                                              [](int x, int y) { return x < 4 || y < 3; })},
                                      {}, 0.1)
                                .position);
        return found;
    };
    const auto targets = kernels::supportedTargets();
    kernels::onlyUseTarget(targets.back());
    const auto plain = positions();
    for (const char* target : targets) {
        kernels::onlyUseTarget(target);
        EXPECT_EQ(positions(), plain) << target;
    }
    kernels::onlyUseTarget(nullptr);
}

TEST(SearchTexture, HalvesByTheMeanOfWhatCounts) {
    Image<SearchPixel> pixels(3, 2);
    pixels(0, 0) = {10, 20, -3, true};
    pixels(1, 0) = {20, 20, -4, true};
    pixels(2, 1) = {7, 8, 9, true};
    pixels(1, 1) = {99, 99, 99, false};
    const Image<SearchPixel> half = halved(pixels);
    ASSERT_EQ(half.width(), 2);
    ASSERT_EQ(half.height(), 1);
    EXPECT_TRUE(half(0, 0).counts);
    EXPECT_EQ(half(0, 0).r, 15);
    EXPECT_EQ(half(0, 0).g, 20);
    EXPECT_EQ(half(0, 0).b, -4);  // halves away from 0
    EXPECT_EQ(half(1, 0).b, 9);
    EXPECT_FALSE(halved(Image<SearchPixel>(2, 2))(0, 0).counts);
}

TEST(BlockSearch, LargestTemplateDoesNotOverflow) {
    // 256 x 256 pixels of opposite extremes: the largest sum there can be, about 3.1e9.
    ColorImage source(300, 257, glm::vec3(1));
    for (int y = 0; y < 257; ++y) source(299, y) = glm::vec3(-1);
    const ColorImage black(256, 256, glm::vec3(-1));
    // The one position whose last column isn't white is the best.
    EXPECT_EQ(find(source, cutOut(SearchTexture(source), black, {0, 0}, 256, all)).x, 44);
}

TEST(BlockSearch, EveryInstructionSetFindsTheSame) {
    const ColorImage source = exactNoise(61, 53, 8), picture = exactNoise(64, 64, 9);
    const SearchTexture prepared(source);
    Random numbers(10);
    std::vector<SearchTemplate> goals;
    for (int i = 0; i < 12; ++i) {
        const int side = 4 + int(numbers.below(29)), left = int(numbers.below(9)),
                  top = int(numbers.below(9));
        goals.push_back(cutOut(prepared, picture, {i, 2 * i}, side, [&](int x, int y) {
            return x < left || y < top || (i % 3 == 0 && numbers.below(3) == 0);
        }));
    }
    const auto positions = [&] {
        std::vector<glm::ivec2> found;
        for (const SearchTemplate& goal : goals) found.push_back(find(source, goal, 0.1));
        return found;
    };
    const auto targets = kernels::supportedTargets();
    ASSERT_FALSE(targets.empty());
    kernels::onlyUseTarget(targets.back());
    const auto plain = positions();
    for (const char* target : targets) {
        kernels::onlyUseTarget(target);
        EXPECT_EQ(positions(), plain) << target;
    }
    kernels::onlyUseTarget(nullptr);
}

TEST(BlockSearch, RoundingCostsLittle) {
    // Overlap error of the block that the search finds against the best there is, on a natural texture.
    const ColorImage source = test::waves(90, 70, 11), picture = test::waves(120, 60, 12);
    const SearchTexture prepared(source);
    const int side = 16;
    const Counts corner = [](int x, int y) { return x < 4 || y < 4; };
    double found = 0, best = 0;
    for (int i = 0; i < 24; ++i) {
        const glm::ivec2 at(4 * i, i);
        double smallest = std::numeric_limits<double>::max();
        for (int y = 0; y + side <= source.height(); ++y)
            for (int x = 0; x + side <= source.width(); ++x)
                smallest = std::min(smallest, bruteForce(source, {x, y}, picture, at, side, corner));
        best += smallest;
        found += bruteForce(source, find(source, cutOut(prepared, picture, at, side, corner)), picture, at,
                            side, corner);
    }
    EXPECT_LT(found, 1.005 * best);
}

}  // namespace
}  // namespace chiaro::synthesis
