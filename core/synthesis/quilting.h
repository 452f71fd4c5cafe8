#pragma once

#include "core/base/image.h"
#include "core/base/parameters.h"
#include "core/base/task.h"

#include <cstdint>

namespace chiaro::synthesis {

/// Image quilting (Efros and Freeman 2001), shared by all methods.
struct QuiltParams {
    int block = 32;          ///< side of a block, 4..256 px
    int overlap = 0;         ///< px; 0 is automatic: round(block / 6), at least 2
    double tolerance = 0.1;  ///< pick at random among candidates within (1 + tolerance) of the smallest error
    std::uint64_t seed = 1;
    static const ParameterTable<QuiltParams>& table();
    int overlapPixels() const;
    friend bool operator==(const QuiltParams&, const QuiltParams&) = default;
};

/// What was made, and how well it fits.
struct QuiltReport {
    std::size_t blocks = 0;
    double overlapError = 0;  ///< mean squared RGB difference over the overlap pixels, before the cut
};

}  // namespace chiaro::synthesis
