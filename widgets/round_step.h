#pragma once

namespace chiaro::widgets {

/// A step of 1, 2 or 5 times a power of ten of which at most `count` fit into a range > 0: for ticks.
double roundStep(double range, int count);

}  // namespace chiaro::widgets
