#include "core/export/atlas.h"

#include "core/base/error.h"
#include "core/scene/mesh_io.h"
#include "tests/core/export/flat_overlap.h"
#include "tests/core/views/meshes.h"
#include "tests/support/support.h"

#include <glm/gtc/matrix_transform.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <map>

namespace chiaro::exporting {
namespace {

PlannedPlace placeOf(scene::Mesh mesh, const glm::mat4& transform = glm::mat4(1)) {
    views::ViewParams params;
    params.size = 96;
    params.count = 8;
    return {methods::planObject(std::make_shared<const scene::Mesh>(std::move(mesh)), params), transform};
}

std::array<glm::dvec2, 3> exact(const std::array<glm::vec2, 3>& face) {
    return {glm::dvec2(face[0]), glm::dvec2(face[1]), glm::dvec2(face[2])};
}

double areaOf(const std::array<glm::vec2, 3>& face) {
    return test::commonArea(exact(face), exact(face));
}

/// Every face lies in the atlas, apart from all others, and shares its vertices with its chart's.
void expectSound(const Atlas& atlas, const std::vector<PlannedPlace>& places) {
    std::vector<std::array<glm::vec2, 3>> all;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const views::Surface& surface = places[i].planned->surface;
        ASSERT_EQ(atlas.objects[i].corners.size(), surface.faceCount());
        std::map<std::pair<std::uint32_t, std::uint32_t>, glm::vec2> vertices;
        for (std::uint32_t face = 0; face < surface.faceCount(); ++face) {
            const auto& corners = atlas.objects[i].corners[face];
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_TRUE(corners[k].x >= 0 && corners[k].x <= float(atlas.size));
                EXPECT_TRUE(corners[k].y >= 0 && corners[k].y <= float(atlas.size));
                const std::pair key(atlas.objects[i].chart[face], surface.mesh().triangles[face][k]);
                EXPECT_EQ(vertices.try_emplace(key, corners[k]).first->second, corners[k]);
            }
            EXPECT_EQ(areaOf(corners) > 0, surface.area(face) > 0) << face;
            if (surface.area(face) > 0) all.push_back(corners);
        }
    }
    double overlap = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j)
            overlap += test::commonArea(exact(all[i]), exact(all[j]));
    EXPECT_LT(overlap, 1e-2);  // texels: the rounding of thousands of shared edges
    EXPECT_EQ(atlas.report.overlap, 0);
}

TEST(Atlas, ASquareFillsItUpToThePadding) {
    const std::vector<PlannedPlace> places{placeOf(test::square(0))};
    const Atlas atlas = makeAtlas(places, {256, 16});
    expectSound(atlas, places);
    EXPECT_EQ(atlas.report.charts, 1u);
    EXPECT_EQ(atlas.report.faces, 2u);
    EXPECT_NEAR(atlas.report.densityP5, (256 - 16) / 2.0, 1);  // texels a unit, of a square of side 2
    EXPECT_NEAR(atlas.report.densityP95, atlas.report.densityP5, 1e-3);
    EXPECT_NEAR(atlas.report.coverage, std::pow(240.0 / 256, 2), 0.02);
}

TEST(Atlas, GivesObjectsOfAnySizeOneDensity) {
    const glm::mat4 quarter = glm::scale(glm::mat4(1), glm::vec3(0.25f));
    const glm::mat4 mirrored = glm::scale(glm::mat4(1), glm::vec3(-1, 1, 1));
    const std::vector<PlannedPlace> places{placeOf(test::square(0)), placeOf(test::square(0), quarter),
                                           placeOf(test::box({0, 0, 0}, glm::vec3(0.5f)), mirrored)};
    const Atlas atlas = makeAtlas(places, {512, 4});
    expectSound(atlas, places);
    EXPECT_EQ(atlas.report.charts, 1u + 1 + 6);
    EXPECT_NEAR(atlas.report.densityP95 / atlas.report.densityP5, 1, 1e-3);
    EXPECT_NEAR(areaOf(atlas.objects[0].corners[0]) / areaOf(atlas.objects[1].corners[0]), 16, 1e-2);
}

TEST(Atlas, LaysAFaceOutAsItIs) {
    // Turned and moved in the world, sides 3, 4 and 5: they keep their ratios.
    const glm::mat4 turned = glm::rotate(glm::mat4(1), 1.0f, glm::vec3(1, 2, 3));
    const Atlas atlas =
        makeAtlas({placeOf(test::triangle({0, 0, 0}, {3, 0, 0}, {0, 4, 0}), turned)}, {128, 2});
    const auto& [a, b, c] = atlas.objects[0].corners[0];
    EXPECT_NEAR(glm::distance(a, b) / glm::distance(b, c), 3.0 / 5, 1e-4);
    EXPECT_NEAR(glm::distance(a, c) / glm::distance(b, c), 4.0 / 5, 1e-4);
    // Not mirrored: seen from the front a, b, c run counter-clockwise, and y goes down.
    EXPECT_LT((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 0);
}

TEST(Atlas, TakesMeshesOfEveryKindOfTrouble) {
    for (const test::OddMesh& odd : test::oddMeshes()) {
        SCOPED_TRACE(odd.what);
        const std::vector<PlannedPlace> places{placeOf(scene::merged(odd.parts))};
        expectSound(makeAtlas(places, {256, 2}), places);
    }
}

TEST(Atlas, OfARoundThingHasFewChartsAndLittleStretch) {
    const std::vector<PlannedPlace> places{placeOf(test::ball(48, 24))};
    const Atlas atlas = makeAtlas(places, {512, 8});
    expectSound(atlas, places);
    EXPECT_LE(atlas.report.charts, 16u);
    EXPECT_LT(atlas.report.densityP95 / atlas.report.densityP5, 1.25);
    EXPECT_GT(atlas.report.coverage, 0.35);
}

TEST(Atlas, GivesUpPaddingWhereThereAreManyCharts) {
    scene::Mesh confetti;
    for (int i = 0; i < 400; ++i) {
        const auto x = float(i);
        confetti = scene::merged({confetti, test::triangle({x, 0, 0}, {x + 0.5f, 0, 0}, {x, 0.5f, 0})});
    }
    const std::vector<PlannedPlace> places{placeOf(confetti)};
    const Atlas roomy = makeAtlas(places, {512, 8});
    EXPECT_EQ(roomy.report.padding, 8);
    EXPECT_EQ(roomy.report.charts, 400u);
    const Atlas narrow = makeAtlas(places, {128, 8});
    EXPECT_LT(narrow.report.padding, 8);
    expectSound(narrow, places);
    scene::Mesh more = confetti;
    for (int i = 0; i < 4; ++i) more = scene::merged({more, more});
    EXPECT_THROW(makeAtlas({placeOf(more)}, {64, 8}), Error);  // 6400 charts, 4096 texels
}

TEST(Atlas, RefusesSizesOutOfRange) {
    const std::vector<PlannedPlace> places{placeOf(test::square(0))};
    EXPECT_THROW(makeAtlas(places, {32, 8}), Error);
    EXPECT_THROW(makeAtlas(places, {16384, 8}), Error);
    EXPECT_THROW(makeAtlas(places, {512, -1}), Error);
}

TEST(Atlas, IsTheSameWithAnyNumberOfThreads) {
    const std::vector<PlannedPlace> places{placeOf(test::ball(32, 16)), placeOf(test::ball(20, 10))};
    const Atlas many = makeAtlas(places, {256, 4});
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Atlas single = makeAtlas(places, {256, 4});
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_EQ(many.objects[i].corners, single.objects[i].corners);
        EXPECT_EQ(many.objects[i].chart, single.objects[i].chart);
    }
}

TEST(Atlas, OfRealMeshesHasNoOverlapAndLittleStretch) {
    CHIARO_NEEDS_SHARED_DATA();
    for (const char* name : {"teapot.stl", "suzanne.ply", "non_manifold_wrap.obj"}) {
        SCOPED_TRACE(name);
        std::vector<PlannedPlace> places;
        for (scene::Mesh& mesh : scene::readModel(test::sharedData() / "meshes" / name).meshes)
            places.push_back(placeOf(std::move(mesh)));
        const Atlas atlas = makeAtlas(places, {1024, 2});
        EXPECT_EQ(atlas.report.overlap, 0);
        EXPECT_LT(atlas.report.densityP95 / atlas.report.densityP5, 1.5);
    }
}

}  // namespace
}  // namespace chiaro::exporting
