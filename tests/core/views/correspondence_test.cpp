#include "core/views/correspondence.h"

#include "tests/core/views/meshes.h"

#include <gtest/gtest.h>

namespace chiaro::views {
namespace {

TEST(Correspondence, SharedFacesAreThoseOfBoth) {
    FaceGroup a;
    FaceGroup b;
    a.faces = {1, 3, 5, 7};
    b.faces = {0, 3, 4, 7, 9};
    EXPECT_EQ(sharedFaces(a, b), (std::vector<std::uint32_t>{3, 7}));
}

TEST(Correspondence, MapsCornersToCornersAndInsidesExactly) {
    const Surface ball = test::surfaceOf({test::ball(20, 12)});
    for (const Projection projection : {Projection::Orthographic, Projection::Perspective}) {
        ViewParams params;
        params.projection = projection;
        const ViewPlan plan = planViews(ball, params);
        std::size_t pairs = 0;
        for (std::size_t i = 0; i < plan.groups.size(); ++i)
            for (std::size_t j = 0; j < plan.groups.size(); ++j) {
                const Projector from(plan.groups[i].view);
                const Projector to(plan.groups[j].view);
                for (const std::uint32_t face : sharedFaces(plan.groups[i], plan.groups[j])) {
                    const std::optional<AffineMap> map = triangleMap(ball, face, from, to);
                    ASSERT_TRUE(map.has_value());
                    const auto missed = [&](const glm::dvec3& point) {
                        return glm::distance((*map)(glm::dvec2(from.project(point))),
                                             glm::dvec2(to.project(point)));
                    };
                    for (std::size_t k = 0; k < 3; ++k) EXPECT_LT(missed(ball.corner(face, k)), 1e-8);
                    EXPECT_LT(missed(ball.centroid(face)), projection == Projection::Orthographic ? 1e-8 : 3);
                    ++pairs;
                }
            }
        EXPECT_GT(pairs, 1000u);
    }
}

TEST(Correspondence, AViewMapsToItselfByNothing) {
    const Surface plane = test::surfaceOf({test::square(0)});
    const Projector front(framed(View{}, plane));
    const std::optional<AffineMap> map = triangleMap(plane, 0, front, front);
    ASSERT_TRUE(map.has_value());
    EXPECT_NEAR(glm::distance((*map)({100, 200}), glm::dvec2(100, 200)), 0, 1e-9);
}

TEST(Correspondence, RefusesFacesSeenEdgeOn) {
    const Surface plane = test::surfaceOf({test::square(0), test::triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0})});
    View side;
    side.direction = {1, 0, 0};
    const Projector front(framed(View{}, plane));
    const Projector edge(framed(side, plane));
    EXPECT_FALSE(triangleMap(plane, 0, edge, front).has_value());
    EXPECT_TRUE(triangleMap(plane, 0, front, edge).has_value());
    EXPECT_FALSE(triangleMap(plane, 2, front, front).has_value());
}

}  // namespace
}  // namespace chiaro::views
