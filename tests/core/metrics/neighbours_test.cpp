#include "core/metrics/neighbours.h"

#include "core/base/error.h"
#include "core/synthesis/search_kernels.h"
#include "tests/core/metrics/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>

namespace chiaro::metrics {
namespace {

/// All source pixels by distance, then in raster order.
std::vector<Neighbour> bruteForce(const BinImage& source, const Descriptor& query, int block,
                                  std::size_t count) {
    std::vector<Neighbour> all;
    for (int y = 0; y < source.height(); ++y)
        for (int x = 0; x < source.width(); ++x) {
            const Block around({x, y}, block);
            if (!around.isInside(source.width(), source.height())) continue;
            all.push_back({{x, y}, distance(describe(source, around), query, block)});
        }
    std::ranges::stable_sort(all, {}, &Neighbour::distance);
    all.resize(std::min(count, all.size()));
    return all;
}

struct Case {
    const char* name;
    ColorImage source, picture;
};

std::vector<Case> cases() {
    return {{"noise", test::speckled(41, 30, 1), test::speckled(24, 20, 2)},
            {"ties", test::blotched(50, 27, 1), test::blotched(24, 20, 2)},
            {"its own", test::speckled(37, 29, 5), test::part(test::speckled(37, 29, 5), 5, 4, 24, 20)}};
}

TEST(Neighbours, AreThoseOfBruteForce) {
    for (const auto& [name, source, picture] : cases())
        for (const int block : {4, 7, 8, 12, 16}) {
            const NeighbourIndex index(source, block);
            const BinImage image = binned(picture, index.bins()), own = binned(source, index.bins());
            std::vector<Descriptor> queries;
            for (int y = block / 2; y + block - block / 2 <= image.height(); y += 2)
                for (int x = block / 2; x + block - block / 2 <= image.width(); x += 3)
                    queries.push_back(describe(image, {{x, y}, block}));
            for (const int count : {1, 3, 40}) {
                NeighbourIndex::Memory memory;
                const auto found = index.nearest(queries, count, memory);
                ASSERT_EQ(found.size(), queries.size());
                for (std::size_t i = 0; i < queries.size(); ++i) {
                    const auto expected = bruteForce(own, queries[i], block, std::size_t(count));
                    ASSERT_EQ(found[i].size(), expected.size());
                    for (std::size_t k = 0; k < expected.size(); ++k) {
                        ASSERT_EQ(found[i][k].pixel, expected[k].pixel) << name << " " << block << " " << k;
                        ASSERT_NEAR(found[i][k].distance, expected[k].distance, 1e-6);
                    }
                    EXPECT_EQ(index.nearest(queries[i], count), found[i]);
                }
            }
        }
}

TEST(Neighbours, AreTheSameOnEveryProcessor) {
    const ColorImage source = test::speckled(41, 30, 1), picture = test::speckled(30, 20, 2);
    for (const int block : {8, 12, 16}) {
        std::vector<std::vector<Neighbour>> expected;
        std::vector<const char*> targets = synthesis::kernels::supportedTargets();
        targets.insert(targets.begin(), nullptr);
        for (const char* target : targets) {
            synthesis::kernels::onlyUseTarget(target);
            const NeighbourIndex index(source, block);
            const BinImage image = binned(picture, index.bins());
            std::vector<Descriptor> queries;
            for (int x = 8; x < 22; ++x) queries.push_back(describe(image, {{x, 9}, block}));
            NeighbourIndex::Memory memory;
            const auto found = index.nearest(queries, 5, memory);
            if (!target) expected = found;
            EXPECT_EQ(found, expected) << (target ? target : "best") << " " << block;
        }
        synthesis::kernels::onlyUseTarget(nullptr);
    }
}

TEST(Neighbours, OfTheSourceAreItself) {
    const ColorImage source = test::speckled(60, 40, 9);
    const NeighbourIndex index(source, 8);
    const BinImage image = binned(source, index.bins());
    for (int x = 4; x < 57; ++x) {
        const auto found = index.nearest(describe(image, {{x, 20}, 8}), 2);
        EXPECT_EQ(found[0], (Neighbour{{x, 20}, 0}));
        EXPECT_GT(found[1].distance, 0);
    }
}

TEST(Neighbours, OfASourceOfOneBlockAreOne) {
    const ColorImage source = test::speckled(8, 8, 9);
    const NeighbourIndex index(source, 8);
    const auto found = index.nearest(Descriptor{}, 3);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].pixel, glm::ivec2(4, 4));
}

TEST(Neighbours, RefusesInASentence) {
    const ColorImage source = test::speckled(20, 9, 1);
    EXPECT_THROW(NeighbourIndex(source, 3), Error);
    EXPECT_THROW(NeighbourIndex(source, 17), Error);
    EXPECT_THROW(NeighbourIndex(source, 10), Error);
    EXPECT_THROW(NeighbourIndex(ColorImage(20, 20, glm::vec3(0.5f)), 8), Error);
    EXPECT_THROW(NeighbourIndex(source, 8).nearest(Descriptor{}, 0), Error);
}

TEST(Neighbours, CanBeCancelled) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(NeighbourIndex(test::speckled(64, 64, 1), 8, Task(stop.get_token())), Cancelled);
}

}  // namespace
}  // namespace chiaro::metrics
