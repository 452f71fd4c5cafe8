#pragma once

#include <cstdint>

namespace chiaro {

/// Counter-based random numbers (SplitMix64, Steele et al. 2014): a value that depends only on the seed, the
/// stream and how many numbers were drawn, so that work split over threads gives the same bytes. Pass by
/// value.
class Random {
public:
    explicit constexpr Random(std::uint64_t seed, std::uint64_t stream = 0)
        : m_state(mix(seed + golden) ^ mix(mix(stream + golden) + golden)) {}

    /// 64 uniform bits.
    constexpr std::uint64_t bits() { return mix(m_state += golden); }
    /// Uniform in [0, 1).
    constexpr double uniform() { return double(bits() >> 11) * 0x1.0p-53; }
    /// Uniform in [0, count); count is at least 1.
    constexpr std::uint64_t below(std::uint64_t count) { return std::uint64_t(double(count) * uniform()); }

private:
    static constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ULL;
    static constexpr std::uint64_t mix(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31);
    }

    std::uint64_t m_state;
};

}  // namespace chiaro
