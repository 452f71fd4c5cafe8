#include "core/views/coverage.h"

#include "core/views/group_map.h"
#include "tests/core/views/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace chiaro::views {
namespace {

TEST(Coverage, OfABoxSeenFromACornerAndTheFront) {
    const Surface box = test::surfaceOf({test::box({0, 0, 0}, glm::vec3(1))});
    View corner;
    corner.direction = {1, 1, 1};
    View front;
    ViewParams params;
    params.count = 2;
    const ViewPlan plan = planViews(box, params, {corner, front});
    const CoverageReport report = measureCoverage(box, plan);
    ASSERT_GE(report.views.size(), 3u);
    EXPECT_EQ(report.views[0].faces, 6u);
    EXPECT_NEAR(report.views[0].area, 0.5, 1e-12);
    EXPECT_NEAR(report.views[0].meanAngle, 54.7356, 1e-4);  // acos(1 / sqrt 3)
    EXPECT_EQ(report.views[1].faces, 2u);
    EXPECT_NEAR(report.views[1].meanAngle, 0, 1e-6);
    EXPECT_NEAR(report.views[0].overlap[1], 1.0 / 6, 1e-12);
    EXPECT_EQ(report.covered, 1);
    EXPECT_EQ(report.facesPerPass[0], 6u);
}

TEST(Coverage, AddsUp) {
    for (const test::OddMesh& odd : test::oddMeshes()) {
        SCOPED_TRACE(odd.what);
        const Surface surface = test::surfaceOf(odd.parts);
        ViewParams params;
        params.size = 128;
        const ViewPlan plan = planViews(surface, params);
        const CoverageReport report = measureCoverage(surface, plan);
        EXPECT_EQ(report.covered, 1);
        EXPECT_EQ(report.faces, surface.faceCount());
        EXPECT_EQ(std::accumulate(report.facesPerPass.begin(), report.facesPerPass.end(), std::size_t(0)) +
                      report.unreachable,
                  report.faces);
        EXPECT_EQ(report.facesPerPass.size(), std::size_t(plan.passes));
        for (std::size_t i = 0; i < report.views.size(); ++i) {
            EXPECT_EQ(report.views[i].faces, plan.groups[i].faces.size());
            EXPECT_GE(report.views[i].meanAngle, 0);
            EXPECT_LT(report.views[i].meanAngle, 87.2);  // acos 0.05
            EXPECT_NEAR(report.views[i].overlap[i], report.views[i].area, 1e-12);
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_EQ(report.views[i].overlap[j], report.views[j].overlap[i]);
        }
    }
}

TEST(GroupMap, ShowsTheGroupsFacesWhereTheyProject) {
    const Surface squares = test::surfaceOf({test::square(0), test::square(0.5f, 0.5f)});
    FaceGroup group;
    group.view = framed(View{}, squares);
    group.faces = {0, 1};  // the small square in front is not drawn
    const FaceMap map = drawGroup(squares, group);
    EXPECT_EQ(map.face(0, 0), noFace);
    EXPECT_EQ(map.depth(0, 0), std::numeric_limits<float>::infinity());
    EXPECT_EQ(map.face(300, 290), 0u);
    EXPECT_EQ(map.face(290, 210), 1u);
    EXPECT_NEAR(map.depth(300, 290), Projector(group.view).project({0, 0, 0}).z, 1e-6);
    const auto covered = std::ranges::count_if(map.face.pixels(), [](auto face) { return face != noFace; });
    EXPECT_NEAR(double(covered), std::pow(512 * 0.96, 2), 2000);
    const FaceMap both = drawFaces(squares, group.view, {1, 1, 1, 1});
    EXPECT_EQ(both.face(300, 290), 2u);
    EXPECT_EQ(both.face(300, 460), 0u);
}

}  // namespace
}  // namespace chiaro::views
