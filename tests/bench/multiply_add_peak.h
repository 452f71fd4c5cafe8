#pragma once

#include <string_view>

namespace chiaro::bench {

/// Multiply-adds of bytes that a core does in a second of its time when all cores do nothing but the search's
/// own instructions, on registers alone: what the search's speed is compared with. `target` is a name of
/// kernels::supportedTargets; 0 where there is no such loop.
double multiplyAddPeak(std::string_view target);

}  // namespace chiaro::bench
