#include "tests/bench/multiply_add_peak.h"

#ifdef __x86_64__

#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <immintrin.h>
#include <thread>
#include <vector>

namespace chiaro::bench {

namespace {

constexpr int rounds = 2'000'000;
constexpr int sums = 12;  // independent, to hide the latency

// Makes the compiler believe that a register changed.
#define CHIARO_TOUCH(value) asm volatile("" : "+x"(value))

__attribute__((target("avx512f,avx512vnni"))) double runAvx512() {
    __m512i source = _mm512_set1_epi8(3), factor = _mm512_set1_epi8(-2), total[sums] = {};
    for (int round = 0; round < rounds; ++round) {
#pragma GCC unroll 12
        for (int i = 0; i < sums; ++i) total[i] = _mm512_dpbusd_epi32(total[i], source, factor);
        CHIARO_TOUCH(source);
    }
#pragma GCC unroll 12
    for (int i = 0; i < sums; ++i) source = _mm512_add_epi32(source, total[i]);
    benchmark::DoNotOptimize(source);
    return 64.0 * sums * rounds;
}

// Two products are added up before they are widened, as in the search.
__attribute__((target("avx2"))) double runAvx2() {
    __m256i source = _mm256_set1_epi8(3), factor = _mm256_set1_epi8(-2), total[6] = {};
    const __m256i ones = _mm256_set1_epi16(1);
    for (int round = 0; round < rounds; ++round) {
#pragma GCC unroll 6
        for (int i = 0; i < 6; ++i) {
            const __m256i upper = _mm256_maddubs_epi16(source, factor);
            CHIARO_TOUCH(source);
            const __m256i lower = _mm256_maddubs_epi16(source, factor);
            CHIARO_TOUCH(source);
            total[i] = _mm256_add_epi32(total[i], _mm256_madd_epi16(_mm256_add_epi16(upper, lower), ones));
        }
    }
#pragma GCC unroll 6
    for (int i = 0; i < 6; ++i) source = _mm256_add_epi32(source, total[i]);
    benchmark::DoNotOptimize(source);
    return 64.0 * 6 * rounds;
}

__attribute__((target("sse4.1"))) double runSse4() {
    __m128i source = _mm_set1_epi8(3), factor = _mm_set1_epi8(-2), total[6] = {};
    const __m128i ones = _mm_set1_epi16(1);
    for (int round = 0; round < rounds; ++round) {
#pragma GCC unroll 6
        for (int i = 0; i < 6; ++i) {
            const __m128i upper = _mm_maddubs_epi16(source, factor);
            CHIARO_TOUCH(source);
            const __m128i lower = _mm_maddubs_epi16(source, factor);
            CHIARO_TOUCH(source);
            total[i] = _mm_add_epi32(total[i], _mm_madd_epi16(_mm_add_epi16(upper, lower), ones));
        }
    }
#pragma GCC unroll 6
    for (int i = 0; i < 6; ++i) source = _mm_add_epi32(source, total[i]);
    benchmark::DoNotOptimize(source);
    return 32.0 * 6 * rounds;
}

double onAllCores(double (*run)()) {
    std::atomic<double> done = 0;
    const std::clock_t begin = std::clock();
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(std::thread::hardware_concurrency(), 1u); ++i)
        threads.emplace_back([&] { done += run(); });
    threads.clear();
    return done * CLOCKS_PER_SEC / double(std::clock() - begin);
}

}  // namespace

double multiplyAddPeak(std::string_view target) {
    if (target == "AVX3_DL") return onAllCores(runAvx512);
    if (target == "AVX2") return onAllCores(runAvx2);
    if (target == "SSE4") return onAllCores(runSse4);
    return 0;
}

}  // namespace chiaro::bench

#else

double chiaro::bench::multiplyAddPeak(std::string_view) {
    return 0;
}

#endif
