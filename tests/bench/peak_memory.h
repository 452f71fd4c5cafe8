#pragma once

#include <benchmark/benchmark.h>

#include <fstream>
#include <string>

namespace chiaro::bench {

/// The most memory that this process had since the last call, in bytes; 0 where the system doesn't tell.
inline double takePeakMemory() {
    double kilobytes = 0;
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "VmHWM:") status >> kilobytes;
    std::ofstream("/proc/self/clear_refs") << 5;
    return 1024 * kilobytes;
}

/// Tells the most memory since the last takePeakMemory() as the counter "memory", in bytes.
inline void tellPeakMemory(benchmark::State& state) {
    state.counters["memory"] =
        benchmark::Counter(takePeakMemory(), benchmark::Counter::kDefaults, benchmark::Counter::kIs1024);
}

}  // namespace chiaro::bench
