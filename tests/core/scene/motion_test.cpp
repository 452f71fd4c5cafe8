#include "core/scene/motion.h"

#include "tests/core/scene/shapes.h"

#include <gtest/gtest.h>

namespace chiaro::scene {
namespace {

constexpr int size = 101;

Camera turned(float azimuth, float elevation = 0) {
    Camera camera = test::frontCamera();
    camera.azimuth = azimuth;
    camera.elevation = elevation;
    return camera;
}

GBuffer ballFrom(const Camera& camera) {
    const Scene scene = test::sceneOf({test::ball(96, 48)});
    return castGBuffer(RayScene(scene), scene.lights, camera, size, size);
}

TEST(Motion, AViewIsSeenFromItselfWhereItIs) {
    const Camera camera = turned(20, 10);
    const GBuffer gbuffer = ballFrom(camera);
    const Image<SeenPoint> seen = seenFrom(gbuffer, camera, camera);
    int points = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            ASSERT_EQ(seen(x, y).exists(), gbuffer.objectId(x, y) != 0);
            if (!seen(x, y).exists()) continue;
            ++points;
            ASSERT_NEAR(seen(x, y).position.x, float(x) + 0.5f, 2e-4f);
            ASSERT_NEAR(seen(x, y).position.y, float(y) + 0.5f, 2e-4f);
            ASSERT_NEAR(seen(x, y).depth, gbuffer.depth(x, y), 1e-5f * gbuffer.depth(x, y));
            ASSERT_GE(seen(x, y).facing, -1e-5f);
        }
    EXPECT_GT(points, 5000);
}

TEST(Motion, TheMiddleOfTheBallTurnsAwayAsTheCameraGoesAround) {
    const GBuffer gbuffer = ballFrom(turned(0));
    // The camera goes to the right, so what it saw in the middle goes to the left and turns away.
    const SeenPoint point = seenFrom(gbuffer, turned(0), turned(30))(size / 2, size / 2);
    EXPECT_LT(point.position.x, float(size) / 2 - 15);
    EXPECT_NEAR(point.position.y, float(size) / 2, 1e-3f);
    EXPECT_GT(point.facing, 0.7f);
    EXPECT_LT(point.facing, std::cos(glm::radians(30.0f)));  // perspective looks past it
    const SeenPoint behind = seenFrom(gbuffer, turned(0), turned(180))(size / 2, size / 2);
    EXPECT_LT(behind.facing, -0.99f);
    const SeenPoint below = seenFrom(gbuffer, turned(0), turned(0, 30))(size / 2, size / 2);
    EXPECT_GT(below.position.y, float(size) / 2 + 15);
}

TEST(Motion, WhatMovesIsFoundAgainOnTheSameFaceOfTheOtherView) {
    const Camera before = turned(0), after = turned(4);
    const GBuffer from = ballFrom(before), to = ballFrom(after);
    const Image<glm::vec2> motion = screenMotion(from, before, after);
    EXPECT_EQ(motion(0, 0), glm::vec2(0));
    const auto worldPoint = [](const GBuffer& gbuffer, glm::ivec2 pixel) {
        return gbuffer.normal(pixel.x, pixel.y);  // of the unit ball: where the point is
    };
    int compared = 0;
    for (int y = 10; y < size - 10; y += 3)
        for (int x = 10; x < size - 10; x += 3) {
            if (from.objectId(x, y) == 0 || from.normal(x, y).z < 0.5f) continue;
            const glm::ivec2 there = glm::ivec2(glm::floor(glm::vec2(x, y) + 0.5f + motion(x, y)));
            ASSERT_NE(to.objectId(there.x, there.y), 0);
            // Half a pixel of the picture, on a surface that may lie aslant.
            EXPECT_LT(glm::distance(worldPoint(from, {x, y}), worldPoint(to, there)), 0.06f);
            ++compared;
        }
    EXPECT_GT(compared, 200);
}

}  // namespace
}  // namespace chiaro::scene
