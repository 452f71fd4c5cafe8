#include "core/views/thumbnail.h"

#include <gtest/gtest.h>

namespace chiaro::views {
namespace {

/// Two squares one above the other, seen from +Z: faces 0 and 1 in front, 2 and 3 behind, shifted right.
Surface twoSquares() {
    scene::Mesh mesh;
    mesh.positions = {{-1, -1, 1}, {0, -1, 1}, {0, 0, 1}, {-1, 0, 1},
                      {-1, -1, 0}, {1, -1, 0}, {1, 0, 0}, {-1, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
    return Surface(std::make_shared<const scene::Mesh>(std::move(mesh)));
}

FaceGroup groupOf(const Surface& surface, std::vector<std::uint32_t> faces, int pass) {
    FaceGroup group;
    group.view = framed({}, surface);
    group.pass = pass;
    group.faces = std::move(faces);
    return group;
}

/// Samples are averaged, which rounds.
bool areAlike(glm::vec3 a, glm::vec3 b) {
    return glm::distance(a, b) < 1e-5f;
}

TEST(Thumbnail, TintsTheGroupOnly) {
    const Surface surface = twoSquares();
    const ThumbnailStyle style{.side = 40};
    const ColorImage picture = drawThumbnail(surface, groupOf(surface, {0, 1}, 1), style);
    EXPECT_TRUE(areAlike(picture(10, 20), style.painted));  // both squares face the eye: full light
    EXPECT_TRUE(areAlike(picture(30, 20), style.plain));
    EXPECT_TRUE(areAlike(picture(20, 2), style.background));
}

TEST(Thumbnail, WhatIsHiddenShowsOnlyInAFurtherPass) {
    const Surface surface = twoSquares();
    const ThumbnailStyle style{.side = 40};
    const ColorImage first = drawThumbnail(surface, groupOf(surface, {2, 3}, 1), style);
    EXPECT_TRUE(areAlike(first(10, 20), style.plain));
    EXPECT_TRUE(areAlike(first(30, 20), style.painted));
    const ColorImage further = drawThumbnail(surface, groupOf(surface, {2, 3}, 2), style);
    EXPECT_TRUE(areAlike(further(10, 20), style.painted));
    const ColorImage front = drawThumbnail(surface, groupOf(surface, {}, 2), style);
    EXPECT_TRUE(areAlike(front(10, 20), style.receding));
}

TEST(Thumbnail, OneForEachGroupAndNoneWhenCancelled) {
    const Surface surface = twoSquares();
    const ViewPlan plan{{groupOf(surface, {0, 1}, 1), groupOf(surface, {2, 3}, 2)}, {}, 2};
    const auto pictures = drawThumbnails(surface, plan, {.side = 8});
    ASSERT_EQ(pictures.size(), 2U);
    EXPECT_EQ(pictures[1].width(), 8);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(drawThumbnails(surface, plan, {.side = 8}, Task(stop.get_token())), Cancelled);
}

}  // namespace
}  // namespace chiaro::views
