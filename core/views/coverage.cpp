#include "core/views/coverage.h"

#include <algorithm>
#include <cmath>

namespace chiaro::views {

namespace {

ViewCoverage measureView(const Surface& surface, const FaceGroup& group) {
    ViewCoverage coverage;
    coverage.faces = group.faces.size();
    const Projector projector(group.view);
    double area = 0;
    double angles = 0;
    for (const std::uint32_t face : group.faces) {
        const double cosine = projector.facing(surface.centroid(face), surface.normal(face));
        area += surface.area(face);
        angles += surface.area(face) * std::acos(std::clamp(cosine, -1.0, 1.0));
    }
    if (!(area > 0)) return coverage;
    coverage.area = area / surface.totalArea();
    coverage.meanAngle = glm::degrees(angles / area);
    return coverage;
}

}  // namespace

CoverageReport measureCoverage(const Surface& surface, const ViewPlan& plan) {
    CoverageReport report;
    report.faces = surface.faceCount();
    report.unreachable = plan.unreachable.size();
    report.facesPerPass.resize(std::size_t(plan.passes));
    const std::size_t count = plan.groups.size();
    // The groups of each face, so that overlaps take one walk over the faces instead of one a pair of views.
    std::vector<std::vector<std::uint32_t>> groupsOf(surface.faceCount());
    for (std::uint32_t i = 0; i < count; ++i) {
        report.views.push_back(measureView(surface, plan.groups[i]));
        report.views.back().overlap.resize(count);
        for (const std::uint32_t face : plan.groups[i].faces) groupsOf[face].push_back(i);
    }
    double covered = 0;  // summed as the total is, so that all of it is exactly 1
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face) {
        if (groupsOf[face].empty()) continue;
        const double share = surface.area(face) / surface.totalArea();
        covered += surface.area(face);
        int pass = plan.passes;
        for (const std::uint32_t a : groupsOf[face]) {
            pass = std::min(pass, plan.groups[a].pass);
            for (const std::uint32_t b : groupsOf[face]) report.views[a].overlap[b] += share;
        }
        ++report.facesPerPass[std::size_t(pass) - 1];
    }
    if (surface.totalArea() > 0) report.covered = covered / surface.totalArea();
    return report;
}

}  // namespace chiaro::views
