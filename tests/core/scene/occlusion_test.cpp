#include "core/scene/gbuffer.h"
#include "tests/core/scene/shapes.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace chiaro::scene {
namespace {

/// A wall of side 20 in the plane z = 0, and in front of its right half a square lid at z = `gap`, which
/// faces the wall and the eye sees edge-on when it looks along +Z from below.
Scene wallAndLid(float gap, bool wrap) {
    Scene scene = test::sceneOf({test::quad(), test::quad()});
    scene.objects[0].transform = glm::mat4(glm::mat3(10));
    scene.objects[1].transform[3] = {1.5f, 0, gap, 1};
    scene.lights = {{.vector = {0, 0, 1}, .wrap = wrap}};
    return scene;
}

/// What the eye on the left sees of the wall at (x, 0): it looks past the lid.
float lightOnWall(const Scene& scene, float x) {
    Camera camera = test::frontCamera();
    camera.target = {x, 0, 0};
    camera.radius = 0.05f;
    camera.distance = 1;  // the eye is nearer to the wall than the lid is
    return castGBuffer(RayScene(scene), scene.lights, camera, 9, 9).light(4, 4);
}

TEST(Occlusion, IsOffAtFirst) {
    EXPECT_TRUE(Scene{}.occlusion.isOff());
    EXPECT_FLOAT_EQ(lightOnWall(wallAndLid(1, false), 1.5f), 1);
}

TEST(Occlusion, AShadowIsAsDarkAsASurfaceAtARightAngleToTheLight) {
    for (const bool wrap : {false, true}) {
        Scene scene = wallAndLid(1, wrap);
        scene.occlusion.shadows = true;
        EXPECT_FLOAT_EQ(lightOnWall(scene, 1.5f), wrap ? 0.5f : 0);
        EXPECT_FLOAT_EQ(lightOnWall(scene, 0.6f), wrap ? 0.5f : 0);
        EXPECT_FLOAT_EQ(lightOnWall(scene, 0.4f), 1) << "beyond the lid's edge at 0.5";
        EXPECT_FLOAT_EQ(lightOnWall(scene, -3), 1);
    }
}

TEST(Occlusion, APointLightCastsShadowsOnlyFromWhatStandsBeforeIt) {
    Scene scene = wallAndLid(1, false);
    scene.occlusion.shadows = true;
    scene.lights = {{.kind = Light::Kind::Point, .vector = {1.5f, 0, 2}, .wrap = false}};
    EXPECT_FLOAT_EQ(lightOnWall(scene, 1.5f), 0);
    // Twice as far as the lid's edge, as the light is from the lid.
    EXPECT_FLOAT_EQ(lightOnWall(scene, -0.4f), 0);
    EXPECT_NEAR(lightOnWall(scene, -0.6f), 2 / std::hypot(2.0, 2.1), 1e-5);
    scene.lights[0].vector.z = 0.9f;  // between the wall and the lid
    EXPECT_FLOAT_EQ(lightOnWall(scene, 1.5f), 1);
}

TEST(Occlusion, ALightThatIsHiddenGivesNothing) {
    Scene scene = wallAndLid(1, false);
    scene.lights[0].visible = false;
    EXPECT_FLOAT_EQ(lightOnWall(scene, -3), 0);
}

TEST(Occlusion, AnOpenPlaneLosesNothingAndAClosedOneEverything) {
    Scene scene = wallAndLid(0.25f, false);
    scene.objects[1].transform = glm::mat4(glm::mat3(10));
    scene.objects[1].transform[3] = {10.5f, 0, 0.25f, 1};
    scene.occlusion = {.ambient = 1, .ambientRadius = 200};
    EXPECT_FLOAT_EQ(lightOnWall(scene, -8), 1);
    EXPECT_LT(lightOnWall(scene, 8), 0.06f);
    const float rim = lightOnWall(scene, 0.5f);  // half of the sky is closed
    EXPECT_GT(rim, 0.4f);
    EXPECT_LT(rim, 0.6f);
}

TEST(Occlusion, FadesWithTheDistanceAndTheAmount) {
    Scene scene = wallAndLid(1, false);
    scene.objects[1].transform[3] = {0, 0, 1, 1};
    float last = 1;
    for (const double radius : {5.0, 10.0, 20.0, 50.0}) {
        scene.occlusion = {.ambient = 1, .ambientRadius = radius};
        const float light = lightOnWall(scene, 0);
        EXPECT_LE(light, last);
        last = light;
    }
    EXPECT_LT(last, 0.7f);
    scene.occlusion.ambient = 0.5;
    EXPECT_NEAR(lightOnWall(scene, 0), 1 - 0.5f * (1 - last), 1e-5);
    scene.occlusion.ambientRadius = 1;
    EXPECT_FLOAT_EQ(lightOnWall(scene, 0), 1) << "the lid is farther than the radius";
}

TEST(Occlusion, ABallShadesNothingOfItself) {
    Scene scene = test::sceneOf({test::ball(48, 24)});
    const Camera camera = test::frontCamera();
    const GBuffer open = castGBuffer(RayScene(scene), scene.lights, camera, 60, 60);
    scene.occlusion = {.shadows = true, .ambient = 1, .ambientRadius = 50};
    const GBuffer shaded = castGBuffer(RayScene(scene), scene.lights, camera, 60, 60);
    for (std::size_t i = 0; i < open.light.pixelCount(); ++i)
        ASSERT_NEAR(open.light.pixels()[i], shaded.light.pixels()[i], 0.05f) << i;
}

TEST(Occlusion, AnotherOneOfTheSameSurfacesCastsTheSame) {
    Scene scene = wallAndLid(1, false);
    const RayScene plain(scene);
    scene.occlusion = {.shadows = true, .ambient = 0.5, .ambientRadius = 60};
    Camera camera = test::frontCamera();
    camera.azimuth = -60;
    const auto cast = [&](const RayScene& rays) {
        return castGBuffer(rays, scene.lights, camera.framed(boundsOf(scene)), 70, 50);
    };
    const GBuffer built = cast(RayScene(scene)), derived = cast(plain.with(scene.occlusion));
    EXPECT_EQ(built.light, derived.light);
    EXPECT_NE(built.light, cast(plain).light);
    EXPECT_EQ(built.edgeSamples, derived.edgeSamples);
}

TEST(Occlusion, BytesDoNotDependOnTheThreads) {
    Scene scene = test::sceneOf({test::ball(60, 30), test::quad()});
    scene.objects[1].transform = glm::mat4(glm::mat3(3));
    scene.objects[1].transform[3] = {0, 0, -1, 1};
    scene.lights.push_back({.kind = Light::Kind::Point, .vector = {2, 2, 1}, .wrap = false});
    scene.occlusion = {.shadows = true, .ambient = 0.7, .ambientRadius = 40};
    const auto cast = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return castGBuffer(RayScene(scene), scene.lights, Camera{}.framed(boundsOf(scene)), 120, 90);
    };
    const GBuffer one = cast(1), four = cast(4);
    EXPECT_EQ(one.light, four.light);
    EXPECT_EQ(one.edgeSamples, four.edgeSamples);
}

}  // namespace
}  // namespace chiaro::scene
