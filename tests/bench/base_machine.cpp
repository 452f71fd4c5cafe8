// What the machine itself can do: the memory's speed by the triad a = b + 3 c over arrays far larger than its
// caches, read and written bytes together.

#include "tests/bench/thread_counts.h"

#include <benchmark/benchmark.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <vector>

namespace {

constexpr std::size_t length = std::size_t(32) << 20;  // 256 MB an array

void run(benchmark::State& state, std::size_t threadCount) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, threadCount);
    std::vector<double> a(length), b(length, 1), c(length, 2);
    for ([[maybe_unused]] auto _ : state) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, length, 1 << 16), [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i) a[i] = b[i] + 3 * c[i];
        });
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(std::int64_t(state.iterations()) * std::int64_t(3 * sizeof(double) * length));
}

void triad(benchmark::State& state) {
    run(state, std::size_t(state.range(0)));
}
BENCHMARK(triad)
    ->Apply(chiaro::bench::threadCounts)
    ->ArgName("threads")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void triadOnAllThreads(benchmark::State& state) {
    run(state, std::max(std::thread::hardware_concurrency(), 1u));
}
BENCHMARK(triadOnAllThreads)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
