#include "core/base/random.h"
#include "tests/core/gradient/literal_sort.h"

#include <gtest/gtest.h>

#include <chrono>
#include <set>

namespace chiaro::gradient {
namespace {

using test::LiteralSort;

ExactColors greys(std::initializer_list<float> values) {
    ExactColors colors;
    for (const float value : values) colors.emplace_back(value);
    return colors;
}

ExactColors noise(int count, std::uint64_t seed, float spread) {
    Random random(seed);
    ExactColors colors;
    for (int i = 0; i < count; ++i) {
        const auto jitter = [&] { return spread * float(random.uniform() - 0.5); };
        const float x = float(i) / float(count - 1);
        colors.emplace_back(x + jitter(), x * x + jitter(), 0.5f * x + jitter());
    }
    return colors;
}

using Order = std::vector<int>;

TEST(ColorSort, SortsGreysBetweenTheEnds) {
    EXPECT_EQ(sortColumns(greys({0, 0.75f, 0.25f, 0.5f, 1}), 1), (Order{0, 2, 3, 1, 4}));
}

TEST(ColorSort, DropsWhatLiesBeyondTheEnds) {
    EXPECT_EQ(sortColumns(greys({0.25f, 0, 0.5f, 1, 0.75f}), 1), (Order{0, 2, 4}));
}

TEST(ColorSort, TheSphereItselfIsOutside) {
    // Column 1 has the colour of an end: its distance from the middle is the radius, not less.
    EXPECT_EQ(sortColumns(greys({0, 0, 1}), 1), (Order{0, 2}));
    // At right angles to the line, at the radius exactly and a hair inside.
    EXPECT_EQ(sortColumns({glm::dvec3(0, 0.5f, 0), glm::dvec3(0.5f, 1, 0), glm::dvec3(1, 0.5f, 0)}, 1),
              (Order{0, 2}));
    EXPECT_EQ(sortColumns({glm::dvec3(0, 0.5f, 0), glm::dvec3(0.5f, 0.999f, 0), glm::dvec3(1, 0.5f, 0)}, 1),
              (Order{0, 1, 2}));
}

TEST(ColorSort, SearchScaleReachesFurther) {
    const ExactColors bend{glm::dvec3(0), glm::dvec3(0.5f, 0.9f, 0), glm::dvec3(1, 0, 0)};
    EXPECT_EQ(sortColumns(bend, 1), (Order{0, 2}));
    EXPECT_EQ(sortColumns(bend, 2), (Order{0, 1, 2}));
}

TEST(ColorSort, TiesGoToTheSmallerColumn) {
    // Both are 0.25 from the middle, one on each side across the line.
    const ExactColors twins{glm::dvec3(0, 0.5f, 0), glm::dvec3(0.5f, 0.75f, 0), glm::dvec3(0.5f, 0.25f, 0),
                            glm::dvec3(1, 0.5f, 0)};
    EXPECT_EQ(sortColumns(twins, 1), LiteralSort(twins, 1)());
    EXPECT_EQ(sortColumns(twins, 1)[1], 1);
    // Equal colours: the first one found is the first column.
    EXPECT_EQ(sortColumns(greys({0, 0.5f, 0.5f, 1}), 1), (Order{0, 1, 3}));
}

TEST(ColorSort, SmallInputs) {
    EXPECT_EQ(sortColumns({}, 1), Order{});
    EXPECT_EQ(sortColumns(greys({0.5f}), 1), Order{0});
    EXPECT_EQ(sortColumns(greys({0.5f, 0.2f}), 1), (Order{0, 1}));
    EXPECT_EQ(sortColumns(ExactColors(100, glm::dvec3(0.4f)), 4), (Order{0, 99}));
}

TEST(ColorSort, AgreesWithTheLiteralRecursion) {
    for (const int count : {3, 17, 64, 333, 800}) {
        for (const float spread : {0.0f, 0.05f, 0.5f}) {
            for (const double scale : {1.0, 1.3, 2.0, 4.0}) {
                const ExactColors averages = noise(count, std::uint64_t(count), spread);
                const Order order = sortColumns(averages, scale);
                ASSERT_EQ(order, LiteralSort(averages, scale)()) << count << " " << spread << " " << scale;
                EXPECT_EQ(order.front(), 0);
                EXPECT_EQ(order.back(), count - 1);
                EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), order.size()) << "used twice";
            }
        }
    }
}

TEST(ColorSort, AgreesOnColoursWithManyTies) {
    // Eight levels a channel, so that most distances occur many times.
    Random random(3);
    ExactColors averages;
    for (int i = 0; i < 600; ++i)
        averages.emplace_back(double(random.below(8)) / 8, double(random.below(8)) / 8,
                              double(random.below(8)) / 8);
    averages.front() = glm::dvec3(0);
    averages.back() = glm::dvec3(1);
    for (const double scale : {1.0, 1.5, 4.0})
        EXPECT_EQ(sortColumns(averages, scale), LiteralSort(averages, scale)()) << scale;
}

/// §3.1 over whole numbers, where nothing rounds; the scale is a half of a whole number too.
void sortWhole(const std::vector<int>& values, int doubledScale, int a, int b, std::vector<bool>& used,
               Order& order) {
    const auto value = [&](int column) { return values[std::size_t(column)]; };
    int best = -1;
    int least = doubledScale * std::abs(value(a) - value(b));
    for (int c = 0; c < int(values.size()); ++c) {
        const int distance = 2 * std::abs(2 * value(c) - value(a) - value(b));
        if (used[std::size_t(c)] || distance >= least) continue;
        least = distance;
        best = c;
    }
    if (best < 0) return order.push_back(b);
    used[std::size_t(best)] = true;
    sortWhole(values, doubledScale, a, best, used, order);
    sortWhole(values, doubledScale, best, b, used, order);
}

TEST(ColorSort, RoundingDecidesNoTieOfGreyStrips) {
    Random random(11);
    std::vector<int> values;
    ExactColors averages;
    for (int i = 0; i < 400; ++i) {
        values.push_back(i == 0 ? 0 : i == 399 ? 255 * 104 : int(random.below(255 * 104)) / 9 * 9);
        averages.emplace_back(double(values.back()) / (255.0 * 104));
    }
    for (const int doubledScale : {2, 3, 8}) {
        std::vector<bool> used(values.size());
        used.front() = used.back() = true;
        Order order{0};
        sortWhole(values, doubledScale, 0, 399, used, order);
        EXPECT_EQ(sortColumns(averages, doubledScale / 2.0), order) << doubledScale;
    }
}

/// Widest strips, in shapes that leave the slab search little to skip.
TEST(ColorSort, StaysFastAtItsWorst) {
    constexpr int width = 8192;
    Random random(5);
    ExactColors sameRed(width), twoColours(width), cloud(width);
    for (int i = 0; i < width; ++i) {
        const std::size_t at = std::size_t(i);
        sameRed[at] = {0.5f, float(random.uniform()) * 0.99f, float(random.uniform()) * 0.99f};
        twoColours[at] = glm::dvec3(i % 2 == 0 ? 0.2f : 0.8f);
        cloud[at] = {float(random.uniform()), float(random.uniform()), float(random.uniform())};
    }
    for (ExactColors* averages : {&sameRed, &twoColours, &cloud}) {
        averages->front() = glm::dvec3(0);
        averages->back() = glm::dvec3(1);
        for (const double scale : {1.0, 4.0}) {
            const auto start = std::chrono::steady_clock::now();
            const Order order = sortColumns(*averages, scale);
            const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
            EXPECT_LT(seconds.count(), 1.0) << "scale " << scale << ", kept " << order.size();
        }
    }
}

}  // namespace
}  // namespace chiaro::gradient
