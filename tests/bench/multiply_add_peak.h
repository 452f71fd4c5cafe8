#pragma once

#include <string_view>

namespace chiaro::bench {

/// Multiply-adds of bytes a second that all cores together do when nothing but the search's own instructions
/// run, on registers alone: what its speed is compared with. `target` is a name of kernels::supportedTargets;
/// 0 where there is no such loop.
double multiplyAddPeak(std::string_view target);

}  // namespace chiaro::bench
