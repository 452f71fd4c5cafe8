#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <thread>

namespace chiaro::bench {

/// One thread, then twice as many each time, and as many as the machine runs at once.
inline void threadCounts(benchmark::internal::Benchmark* benchmark) {
    const int all = int(std::max(std::thread::hardware_concurrency(), 1u));
    for (int threads = 1; threads < all; threads *= 2) benchmark->Arg(threads);
    benchmark->Arg(all);
}

}  // namespace chiaro::bench
