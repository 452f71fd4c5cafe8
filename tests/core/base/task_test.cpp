#include "core/base/task.h"

#include "core/base/hash.h"
#include "core/base/random.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>
#include <vector>

namespace chiaro {
namespace {

TEST(Task, PartsFillTheWhole) {
    std::vector<double> reports;
    const Task task({}, [&](double fraction) { reports.push_back(fraction); });
    task.part(0.5, 1).part(0, 0.5).report(1);
    task.report(0.25);  // never falls
    task.report(2);
    EXPECT_EQ(reports, (std::vector<double>{0.75, 1}));
}

TEST(Task, CheckpointThrowsOnceCancelled) {
    std::stop_source source;
    const Task task(source.get_token());
    EXPECT_NO_THROW(task.part(0, 1).checkpoint());
    source.request_stop();
    EXPECT_TRUE(task.cancelled());
    EXPECT_THROW(task.part(0, 1).checkpoint(), Cancelled);
    EXPECT_NO_THROW(Task().checkpoint());
}

TEST(Task, StepsOfSeveralThreadsAddUp) {
    double last = 0;
    const Task task({}, [&](double fraction) {
        EXPECT_GT(fraction, last);
        last = fraction;
    });
    Task::Steps steps(task, 400);
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 4; ++i)
            threads.emplace_back([&] {
                for (int step = 0; step < 100; ++step) steps.done();
            });
    }
    EXPECT_EQ(last, 1);
}

TEST(Random, DependsOnSeedAndStreamAlone) {
    Random a(1, 2), again(1, 2), otherSeed(2, 2), otherStream(1, 3);
    const std::uint64_t first = a.bits();
    EXPECT_EQ(first, again.bits());
    EXPECT_NE(first, otherSeed.bits());
    EXPECT_NE(first, otherStream.bits());
}

TEST(Random, IsUniform) {
    Random random(7);
    std::vector<int> counts(10, 0);
    for (int i = 0; i < 100'000; ++i) ++counts[std::size_t(random.below(10))];
    // Five standard deviations of a fair die with ten sides.
    for (const int count : counts) EXPECT_NEAR(count, 10'000, 5 * 95);
    for (int i = 0; i < 1000; ++i) {
        const double value = random.uniform();
        EXPECT_TRUE(value >= 0 && value < 1);
    }
    EXPECT_EQ(random.below(1), 0u);
}

TEST(Hasher, TellsContentsApart) {
    std::set<std::uint64_t> seen;
    seen.insert(Hasher().value());
    seen.insert(Hasher().add(1).value());
    seen.insert(Hasher().add(2).value());
    seen.insert(Hasher().add(1).add(2).value());
    seen.insert(Hasher().add(2).add(1).value());
    seen.insert(Hasher().add("ab").add("c").value());
    seen.insert(Hasher().add("a").add("bc").value());
    const float values[] = {0.5f, 0.25f, 1.0f};
    seen.insert(Hasher().add(std::span<const float>(values)).value());
    seen.insert(Hasher().add(std::span<const float>(values, 2)).value());
    EXPECT_EQ(seen.size(), 9u);
    EXPECT_EQ(Hasher().add("ab").value(), Hasher().add("ab").value());
}

}  // namespace
}  // namespace chiaro
