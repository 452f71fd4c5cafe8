#include "core/views/planning.h"

#include "core/base/error.h"
#include "core/scene/mesh_io.h"
#include "core/views/coverage.h"
#include "tests/core/views/brute_force.h"
#include "tests/core/views/meshes.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

namespace chiaro::views {
namespace {

ViewParams smallMaps() {
    ViewParams params;
    params.size = 128;
    return params;
}

TEST(Planning, GroupsAreRightByBruteForce) {
    for (const test::OddMesh& odd : test::oddMeshes()) {
        SCOPED_TRACE(odd.what);
        const Surface surface = test::surfaceOf(odd.parts);
        test::expectRightGroups(surface, planViews(surface, smallMaps()), smallMaps());
    }
}

TEST(Planning, GroupsOfRealMeshesAreRightByBruteForce) {
    CHIARO_NEEDS_SHARED_DATA();
    for (const char* name : {"cube_no_bottom.obj", "joined_tetrahedra.obj", "non_manifold_wrap.obj",
                             "nested.glb", "tet.ply", "spot_control_mesh.obj", "suzanne.ply", "teapot.stl"}) {
        SCOPED_TRACE(name);
        const Surface surface =
            test::surfaceOf(scene::readModel(test::sharedData() / "meshes" / name).meshes);
        test::expectRightGroups(surface, planViews(surface, smallMaps()), smallMaps());
    }
}

TEST(Planning, EveryFaceWithAreaOfEveryRealMeshIsInAGroup) {
    CHIARO_NEEDS_SHARED_DATA();
    for (const auto& path : test::filesIn(test::sharedData() / "meshes")) {
        SCOPED_TRACE(path.filename());
        const Surface surface = test::surfaceOf(scene::readModel(path).meshes);
        const ViewPlan plan = planViews(surface, {});
        const CoverageReport report = measureCoverage(surface, plan);
        EXPECT_EQ(report.covered, 1);
        for (const std::uint32_t face : plan.unreachable) EXPECT_EQ(surface.area(face), 0);
        EXPECT_LE(plan.groups.size(), 40u);
    }
}

/// The share of the area that no view of a plan sees at 60 degrees or less.
double steepShare(const Surface& surface, const ViewPlan& plan) {
    std::vector<double> best(surface.faceCount(), 0);
    for (const FaceGroup& group : plan.groups)
        for (const std::uint32_t face : group.faces)
            best[face] = std::max(best[face], Projector(group.view).facing(surface, face));
    double steep = 0;
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face)
        if (best[face] < 0.5) steep += surface.area(face);
    return steep / surface.totalArea();
}

void expectSteepFacesSeen(const Surface& surface) {
    const ViewPlan plan = planViews(surface, smallMaps());
    const ViewPlan more = withSteepFacesSeen(surface, plan, smallMaps());
    EXPECT_LT(steepShare(surface, more), 0.01);
    ASSERT_GE(more.groups.size(), plan.groups.size());
    EXPECT_TRUE(std::equal(plan.groups.begin(), plan.groups.end(), more.groups.begin()));
}

TEST(Planning, FacesShownSteeplyOnlyAreSeenBetter) {
    // A wall stands so close before another that it can be looked past at flat angles only.
    const Surface walls = test::surfaceOf({test::square(0), test::square(0.45f)});
    EXPECT_GT(steepShare(walls, planViews(walls, smallMaps())), 0.4);
    expectSteepFacesSeen(walls);
    for (const test::OddMesh& odd : test::oddMeshes()) {
        SCOPED_TRACE(odd.what);
        expectSteepFacesSeen(test::surfaceOf(odd.parts));
    }
}

TEST(Planning, FacesOfRealMeshesShownSteeplyOnlyAreSeenBetter) {
    CHIARO_NEEDS_SHARED_DATA();
    for (const char* name : {"spot_control_mesh.obj", "suzanne.ply", "teapot.stl", "rabbit.obj"}) {
        SCOPED_TRACE(name);
        expectSteepFacesSeen(test::surfaceOf(scene::readModel(test::sharedData() / "meshes" / name).meshes));
    }
}

TEST(Planning, SizeDoesNotMatter) {
    const std::vector<scene::Mesh> parts = test::oddMeshes()[4].parts;
    const auto planAt = [&](float scale) {
        std::vector<scene::Mesh> meshes;
        for (const scene::Mesh& part : parts) meshes.push_back(test::scaled(part, scale));
        return planViews(test::surfaceOf(meshes), smallMaps());
    };
    const ViewPlan plan = planAt(1);
    for (const float scale : {0x1p-20f, 0x1p20f}) {  // about 10^-6 and 10^6
        const ViewPlan other = planAt(scale);
        ASSERT_EQ(other.groups.size(), plan.groups.size());
        for (std::size_t i = 0; i < plan.groups.size(); ++i) {
            EXPECT_EQ(other.groups[i].view.direction, plan.groups[i].view.direction);
            EXPECT_EQ(other.groups[i].faces, plan.groups[i].faces);
        }
    }
}

TEST(Planning, TheSameForAnyNumberOfThreads) {
    const Surface surface = test::surfaceOf({test::ball(40, 20), test::box({0.6f, 0, 0}, glm::vec3(0.7f))});
    std::vector<ViewPlan> plans;
    for (const std::size_t threads : {1, 5}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        plans.push_back(planViews(surface, smallMaps()));
    }
    EXPECT_EQ(plans[0], plans[1]);
}

TEST(Planning, TakesAsManyViewsAsAskedForWhereTheyImproveSomething) {
    const Surface ball = test::surfaceOf({test::ball(40, 20)});
    for (const int count : {1, 2, 12, 64}) {
        ViewParams params = smallMaps();
        params.count = count;
        const ViewPlan plan = planViews(ball, params);
        EXPECT_EQ(std::ranges::count(plan.groups, 1, &FaceGroup::pass), count);
        EXPECT_EQ(measureCoverage(ball, plan).covered, 1);
    }
    const ViewPlan plane = planViews(test::surfaceOf({test::square(0)}), smallMaps());
    ASSERT_EQ(plane.groups.size(), 1u);  // one look from the front shows all there is
    EXPECT_EQ(plane.groups[0].view.direction, glm::dvec3(0, 0, 1));
}

TEST(Planning, KeepsWhatTheArtistSetAndPlansAroundIt) {
    const Surface ball = test::surfaceOf({test::ball(40, 20)});
    View mine;
    mine.name = "View 3";
    mine.direction = {0.3, 0.2, -0.9};
    mine.up = {1, 0, 0};
    mine.locked = true;
    ViewParams params = smallMaps();
    params.count = 4;
    const ViewPlan plan = planViews(ball, params, {mine});
    ASSERT_EQ(std::ranges::count(plan.groups, 1, &FaceGroup::pass), 4);
    const View& kept = plan.groups[0].view;
    EXPECT_EQ(kept.direction, mine.direction);
    EXPECT_EQ(kept.up, mine.up);
    EXPECT_EQ(kept.name, mine.name);
    EXPECT_TRUE(kept.locked);
    EXPECT_EQ(kept.size, params.size);
    for (std::size_t i = 1; i < 4; ++i) {
        EXPECT_FALSE(plan.groups[i].view.locked);
        EXPECT_NE(plan.groups[i].view.name, mine.name);
        EXPECT_LT(glm::dot(plan.groups[i].view.direction, glm::normalize(mine.direction)), 0.8);
    }
    // All kept: the groups are made anew, and nothing is planned but for what they leave uncovered.
    std::vector<View> all;
    for (std::size_t i = 0; i < 4; ++i) all.push_back(plan.groups[i].view);
    EXPECT_EQ(planViews(ball, params, all), plan);
}

TEST(Planning, AKeptViewMaySeeNothing) {
    const Surface plane = test::surfaceOf({test::square(0)});
    View behind;
    behind.direction = {0, 0, -1};
    const ViewPlan plan = planViews(plane, smallMaps(), {behind});
    ASSERT_EQ(plan.groups.size(), 2u);
    EXPECT_TRUE(plan.groups[0].faces.empty());
    EXPECT_EQ(plan.groups[1].faces.size(), 2u);
    EXPECT_EQ(measureCoverage(plane, plan).views[0].faces, 0u);
}

TEST(Planning, FacesWithoutAreaAreToldOf) {
    const Surface line = test::surfaceOf({test::triangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2})});
    const ViewPlan plan = planViews(line, {});
    EXPECT_TRUE(plan.groups.empty());
    EXPECT_EQ(plan.passes, 0);
    EXPECT_EQ(plan.unreachable, std::vector<std::uint32_t>{0});
    EXPECT_EQ(measureCoverage(line, plan).covered, 0);
    EXPECT_TRUE(planViews(test::surfaceOf({}), {}).groups.empty());
}

TEST(Planning, WorksInPerspective) {
    ViewParams params = smallMaps();
    params.projection = Projection::Perspective;
    for (const test::OddMesh& odd : test::oddMeshes()) {
        SCOPED_TRACE(odd.what);
        const Surface surface = test::surfaceOf(odd.parts);
        const ViewPlan plan = planViews(surface, params);
        EXPECT_EQ(measureCoverage(surface, plan).covered, 1);
        for (const FaceGroup& group : plan.groups)
            for (const std::uint32_t face : group.faces)
                EXPECT_GT(Projector(group.view).facing(surface, face), params.epsilon);
    }
}

TEST(Planning, RefusesWhatIsOutOfRangeAndHearsOfCancellation) {
    const Surface plane = test::surfaceOf({test::square(0)});
    ViewParams params;
    params.count = 65;
    EXPECT_THROW(planViews(plane, params), Error);
    params = {};
    params.up = glm::dvec3(0);
    EXPECT_THROW(planViews(plane, params), Error);
    View view;
    view.direction = glm::dvec3(0);
    EXPECT_THROW(planViews(plane, {}, {view}), Error);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(planViews(plane, {}, {}, Task(stop.get_token())), Cancelled);
}

}  // namespace
}  // namespace chiaro::views
