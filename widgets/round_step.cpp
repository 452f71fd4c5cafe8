#include "widgets/round_step.h"

#include <cmath>

namespace chiaro::widgets {

double roundStep(double range, int count) {
    const double rough = range / count * (1 - 1e-9);
    const double power = std::pow(10, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough) return factor * power;
    return 10 * power;
}

}  // namespace chiaro::widgets
