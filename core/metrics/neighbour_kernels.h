#pragma once

#include "core/metrics/descriptor.h"

#include <cstddef>
#include <cstdint>

/// The inner loop of the neighbour search, compiled once for each instruction set and picked at run time
/// (Google Highway).
namespace chiaro::metrics::kernels {

/// Descriptors that one vector loop compares at once.
inline constexpr int groupSize = 16;
/// Values in a group: counts 2 p and 2 p + 1 of all its descriptors lie together, for p = 0..74, so that one
/// instruction squares and adds a pair for many descriptors.
inline constexpr std::size_t groupLength = std::size_t(descriptorLength) * groupSize;

/// Where count `i` of descriptor `member` lies in its group.
constexpr std::size_t placeInGroup(std::size_t i, std::size_t member) {
    return (i / 2 * groupSize + member) * 2 + i % 2;
}

/// What the sums may be wrong by, of themselves.
inline constexpr double tolerance = 5e-4;

/// For each descriptor of `groups` groups, the sum of the 15 Euclidean distances to the query, in float with
/// a relative error below `tolerance`, into sums[group * groupSize + member]. Where a whole vector of
/// descriptors is beyond the limit early, only some of the 15 may have been added up, and the sum is beyond
/// the limit too.
void sumsOfDistances(const Descriptor& query, const std::uint8_t* data, std::size_t groups, float limit,
                     float* sums);
void sumsOfDistances(const Descriptor& query, const std::uint16_t* data, std::size_t groups, float limit,
                     float* sums);

}  // namespace chiaro::metrics::kernels
