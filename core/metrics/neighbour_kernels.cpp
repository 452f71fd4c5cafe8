#include "core/metrics/neighbour_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/metrics/neighbour_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
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
