#pragma once

#include "core/views/planning.h"

namespace chiaro::test {

/// Checks every group of a plan (§4.3.2) against the definition, slowly, from the matrices alone: at every
/// texel centre every face is compared with every other. Fails the test for a face in a group where it turns
/// away or is hidden, for one missing where it isn't, and for one with area in no group.
void expectRightGroups(const views::Surface& surface, const views::ViewPlan& plan,
                       const views::ViewParams& params);

}  // namespace chiaro::test
