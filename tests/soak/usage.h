#pragma once

#include <vector>

namespace chiaro::test {

/// What the process holds at a moment.
struct Usage {
    double seconds = 0;   ///< since the first
    double heap = 0;      ///< bytes that were asked for and not given back
    double resident = 0;  ///< bytes of memory in use
    int files = 0;        ///< open descriptors
    int threads = 0;

    static Usage now(double seconds);
};

/// How a figure rises: the median of the slopes between any two of its moments (Theil and Sen), which single
/// odd ones don't move. A second; 0 for fewer than two.
double slopeOf(const std::vector<Usage>& usage, double Usage::*figure);

}  // namespace chiaro::test
