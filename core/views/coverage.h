#pragma once

#include "core/views/planning.h"

#include <vector>

namespace chiaro::views {

/// What one view contributes.
struct ViewCoverage {
    std::size_t faces = 0;
    double area = 0;       ///< of its faces, as a share of the object's, in [0, 1]
    double meanAngle = 0;  ///< between its faces' normals and the view, weighted by area, degrees; 0..90
    std::vector<double> overlap;  ///< area shared with each view of the plan, as a share of the object's;
                                  ///< with itself, `area`
};

/// How well a plan covers its object (§4.3).
struct CoverageReport {
    std::vector<ViewCoverage> views;        ///< one a group, in the plan's order
    double covered = 0;                     ///< share of the object's area that is in a group, in [0, 1]
    std::vector<std::size_t> facesPerPass;  ///< first covered in pass 1, 2, ...
    std::size_t unreachable = 0;            ///< faces without area
    std::size_t faces = 0;                  ///< of the object
};

/// Measures a plan of this surface. Its order of pairs for synthesis: the largest overlaps first.
CoverageReport measureCoverage(const Surface& surface, const ViewPlan& plan);

}  // namespace chiaro::views
