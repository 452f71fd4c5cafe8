#include "core/metrics/neighbour_kernels.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/metrics/neighbour_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
#undef CHIARO_SMALL_COUNTS
namespace chiaro::metrics::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Sums = hn::CappedTag<float, groupSize>;
constexpr Sums floats;

// Exact roots would take most of the time. x86 estimates them within 1 in 2600, others more coarsely.
HWY_INLINE hn::Vec<Sums> roots(hn::Vec<Sums> values) {
#if HWY_ARCH_X86
    const auto positive = hn::Max(values, hn::Set(floats, 1e-12f));
    return hn::Mul(values, hn::ApproximateReciprocalSqrt(positive));
#else
    return hn::Sqrt(values);
#endif
}

#if HWY_TARGET == HWY_SCALAR

// Any other processor: a descriptor at a time.
template <class Count>
HWY_INLINE hn::Vec<Sums> histogramDistance(const std::int32_t* query, const Count* data) {
    std::int16_t wanted[binCount];
    hwy::CopyBytes<sizeof(wanted)>(query, wanted);
    int sum = 0;
    for (int i = 0; i < binCount; ++i) {
        const int difference = int(data[placeInGroup(std::size_t(i), 0)]) - wanted[i];
        sum += difference * difference;
    }
    return roots(hn::Set(floats, float(sum)));
}

#else

using Squares = hn::RebindToSigned<Sums>;
using Pairs = hn::Repartition<std::int16_t, Squares>;
constexpr Squares squares;
constexpr Pairs pairs;

HWY_INLINE hn::Vec<Pairs> loadPairs(const std::uint8_t* data) {
    return hn::PromoteTo(pairs, hn::LoadU(hn::Rebind<std::uint8_t, Pairs>(), data));
}

HWY_INLINE hn::Vec<Pairs> loadPairs(const std::uint16_t* data) {
    return hn::BitCast(pairs, hn::LoadU(hn::RebindToUnsigned<Pairs>(), data));
}

// The Euclidean distance of one histogram.
template <class Count>
HWY_INLINE hn::Vec<Sums> histogramDistance(const std::int32_t* query, const Count* data) {
    auto even = hn::Zero(squares), odd = hn::Zero(squares);
#pragma GCC unroll 5
    for (int i = 0; i < binCount / 2; ++i) {
        const auto wanted = hn::BitCast(pairs, hn::Set(squares, query[i]));
        const auto difference = hn::Sub(loadPairs(data + 2 * groupSize * i), wanted);
        even = hn::ReorderWidenMulAccumulate(squares, difference, difference, even, odd);
    }
    return roots(hn::ConvertTo(floats, hn::RearrangeToOddPlusEven(even, odd)));
}

#endif

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL

// The squared distances of one histogram for a whole group; differences fit into 7 bits and sums into 15.
HWY_INLINE hn::Vec256<std::int16_t> smallSquares(const std::int16_t* query, const std::uint8_t* data) {
    __m256i sum = _mm256_setzero_si256();
#pragma GCC unroll 5
    for (int i = 0; i < binCount / 2; ++i) {
        const __m256i counts = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(data + 2 * groupSize * i));
        const __m256i away = _mm256_abs_epi8(_mm256_sub_epi8(counts, _mm256_set1_epi16(query[i])));
        sum = _mm256_add_epi16(sum, _mm256_maddubs_epi16(away, away));
    }
    return hn::Vec256<std::int16_t>{sum};
}

void sumsOfSmall(const Descriptor& query, const std::uint8_t* data, std::size_t groups, float limit,
                 float* sums) {
    std::int16_t wanted[descriptorLength / 2];  // two counts of 8 bits each
    for (std::size_t i = 0; i < std::size(wanted); ++i)
        wanted[i] = std::int16_t(query[2 * i] | query[2 * i + 1] << 8);
    const auto limits = hn::Set(floats, limit);
    for (std::size_t group = 0; group < groups; ++group) {
        const std::uint8_t* const counts = data + group * groupLength;
        auto lower = hn::Zero(floats), upper = hn::Zero(floats);
        for (int channel = 0; channel < channelCount; ++channel) {
            const auto found =
                smallSquares(wanted + channel * binCount / 2, counts + channel * binCount * groupSize);
#if HWY_TARGET == HWY_AVX2
            lower =
                hn::Add(lower, roots(hn::ConvertTo(floats, hn::PromoteTo(squares, hn::LowerHalf(found)))));
            upper = hn::Add(
                upper,
                roots(hn::ConvertTo(
                    floats, hn::PromoteTo(squares, hn::UpperHalf(hn::Full128<std::int16_t>(), found)))));
            const auto least = hn::Min(lower, upper);
#else
            lower = hn::Add(lower, roots(hn::ConvertTo(floats, hn::PromoteTo(squares, found))));
            const auto least = lower;
#endif
            if (channel % 3 == 2 && hn::AllTrue(floats, hn::Gt(least, limits))) break;
        }
        hn::StoreU(lower, floats, sums + group * groupSize);
        if (hn::Lanes(floats) < groupSize)
            hn::StoreU(upper, floats, sums + group * groupSize + groupSize / 2);
    }
}

#define CHIARO_SMALL_COUNTS 1
#else
#define CHIARO_SMALL_COUNTS 0
#endif

template <class Count>
void sumsOfDistances(const Descriptor& query, const Count* data, std::size_t groups, float limit,
                     float* sums) {
    std::int32_t wanted[descriptorLength / 2];
    hwy::CopyBytes<sizeof(wanted)>(query.data(), wanted);
    const std::size_t stride = hn::Lanes(floats);
    const auto limits = hn::Set(floats, limit);
    for (std::size_t first = 0; first < groups * groupSize; first += stride) {
        const Count* const group = data + first / groupSize * groupLength + first % groupSize * 2;
        auto sum = hn::Zero(floats);
        for (int channel = 0; channel < channelCount; ++channel) {
            sum = hn::Add(sum, histogramDistance(wanted + channel * binCount / 2,
                                                 group + channel * binCount * groupSize));
            if (channel % 3 == 2 && hn::AllTrue(floats, hn::Gt(sum, limits))) break;
        }
        hn::StoreU(sum, floats, sums + first);
    }
}

void sumsOfBytes(const Descriptor& query, const std::uint8_t* data, std::size_t groups, float limit,
                 float* sums) {
#if CHIARO_SMALL_COUNTS
    int pixels = 0;
    for (std::size_t i = 0; i < binCount; ++i) pixels += query[i];
    if (2 * pixels * pixels <= std::numeric_limits<std::int16_t>::max())
        return sumsOfSmall(query, data, groups, limit, sums);
#endif
    sumsOfDistances(query, data, groups, limit, sums);
}

void sumsOfWords(const Descriptor& query, const std::uint16_t* data, std::size_t groups, float limit,
                 float* sums) {
    sumsOfDistances(query, data, groups, limit, sums);
}

}  // namespace chiaro::metrics::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace chiaro::metrics::kernels {

HWY_EXPORT(sumsOfBytes);
HWY_EXPORT(sumsOfWords);

void sumsOfDistances(const Descriptor& query, const std::uint8_t* data, std::size_t groups, float limit,
                     float* sums) {
    HWY_DYNAMIC_DISPATCH(sumsOfBytes)(query, data, groups, limit, sums);
}

void sumsOfDistances(const Descriptor& query, const std::uint16_t* data, std::size_t groups, float limit,
                     float* sums) {
    HWY_DYNAMIC_DISPATCH(sumsOfWords)(query, data, groups, limit, sums);
}

}  // namespace chiaro::metrics::kernels

#endif
