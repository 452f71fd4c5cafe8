#include "core/scene/camera.h"

#include "core/scene/scene.h"
#include "tests/core/scene/shapes.h"

#include <gtest/gtest.h>

namespace chiaro::scene {
namespace {

/// Where a world position lands in the picture: pixels, x right, y down.
glm::vec2 project(const Camera& camera, int width, int height, glm::vec3 point) {
    const glm::vec4 clip = camera.projection(width, height) * camera.view() * glm::vec4(point, 1);
    return {(clip.x / clip.w * 0.5f + 0.5f) * float(width), (0.5f - clip.y / clip.w * 0.5f) * float(height)};
}

void expectNear(glm::vec3 a, glm::vec3 b, float tolerance) {
    EXPECT_LT(glm::length(a - b), tolerance) << a.x << " " << a.y << " " << a.z;
}

TEST(Camera, AzimuthZeroLooksFromPositiveZAndNinetyFromPositiveX) {
    Camera camera = test::frontCamera();
    expectNear(glm::normalize(camera.position()), {0, 0, 1}, 1e-6f);
    camera.azimuth = 90;
    expectNear(glm::normalize(camera.position()), {1, 0, 0}, 1e-6f);
    camera.elevation = 90;
    expectNear(glm::normalize(camera.position()), {0, 1, 0}, 1e-6f);
}

TEST(Camera, RightIsRightAndUpIsUpInThePicture) {
    const Camera camera = test::frontCamera();
    const glm::vec2 centre = project(camera, 200, 100, {0, 0, 0});
    EXPECT_NEAR(centre.x, 100, 1e-4);
    EXPECT_NEAR(centre.y, 50, 1e-4);
    EXPECT_GT(project(camera, 200, 100, {0.1f, 0, 0}).x, centre.x);
    EXPECT_LT(project(camera, 200, 100, {0, 0.1f, 0}).y, centre.y);
}

TEST(Camera, BasisIsOrthonormalAtThePolesToo) {
    for (const float elevation : {-90.0f, -30.0f, 0.0f, 90.0f}) {
        Camera camera;
        camera.azimuth = 200;
        camera.elevation = elevation;
        const glm::mat3 basis = camera.basis();
        EXPECT_NEAR(glm::determinant(basis), 1, 1e-5);
        for (int i = 0; i < 3; ++i) expectNear((glm::transpose(basis) * basis)[i], glm::mat3(1)[i], 1e-5f);
    }
}

TEST(Camera, FramedSphereTouchesTheSmallerSide) {
    Bounds bounds;
    bounds.minimum = {3, 4, 5};
    bounds.maximum = {5, 6, 7};
    bounds.radius = std::sqrt(3.0f);
    Camera camera;
    camera.azimuth = 0;
    camera.elevation = 0;
    camera = camera.framed(bounds);
    expectNear(camera.target, {4, 5, 6}, 1e-6f);
    EXPECT_NEAR(camera.radius, std::sqrt(3.0f), 1e-6);
    // The rays that touch the sphere leave the eye at half the field of view: sin = radius / distance.
    const float sine = camera.radius / camera.eyeDistance();
    const glm::vec3 touching = camera.target + camera.radius * glm::vec3(0, std::sqrt(1 - sine * sine), sine);
    EXPECT_NEAR(project(camera, 300, 200, touching).y, 0, 1e-2);
    EXPECT_NEAR(project(camera, 200, 300,
                        camera.target + camera.radius * glm::vec3(std::sqrt(1 - sine * sine), 0, sine))
                    .x,
                200, 1e-2);
}

TEST(Camera, EyeLiesWhereTheViewMatrixSaysAndTheTargetBetweenThePlanes) {
    Camera camera;
    camera.target = {1, 2, 3};
    for (const float distance : {0.01f, 1.0f, 100.0f}) {
        camera.distance = distance;
        expectNear(camera.view() * glm::vec4(camera.position(), 1), {0, 0, 0}, 1e-4f * camera.eyeDistance());
        EXPECT_LT(camera.nearPlane(), camera.eyeDistance());
        EXPECT_GT(camera.farPlane(), camera.eyeDistance());
        EXPECT_GT(camera.nearPlane(), 0);
    }
}

TEST(Light, FacingIsOneOppositeIsZeroAcrossIsHalf) {
    Light light;
    light.vector = {0, 0, 5};
    EXPECT_FLOAT_EQ(lightValue({light}, {}, {0, 0, 1}), 1);
    EXPECT_FLOAT_EQ(lightValue({light}, {}, {0, 0, -1}), 0);
    EXPECT_FLOAT_EQ(lightValue({light}, {}, {1, 0, 0}), 0.5f);
}

TEST(Light, WithoutWrapTheFarSideIsDark) {
    Light light;
    light.vector = {0, 0, 1};
    light.wrap = false;
    EXPECT_FLOAT_EQ(lightValue({light}, {}, {1, 0, 0}), 0);
    EXPECT_FLOAT_EQ(lightValue({light}, {}, glm::normalize(glm::vec3(1, 0, 1))), std::sqrt(0.5f));
}

TEST(Light, LightsAddUpToAtMostOne) {
    Light half;
    half.vector = {0, 0, 1};
    half.intensity = 0.4f;
    EXPECT_FLOAT_EQ(lightValue({half, half}, {}, {0, 0, 1}), 0.8f);
    EXPECT_FLOAT_EQ(lightValue({half, half, half}, {}, {0, 0, 1}), 1);
    EXPECT_FLOAT_EQ(lightValue({}, {}, {0, 0, 1}), 0);
}

TEST(SceneBounds, FollowTransformsAndLeaveOutWhatIsHidden) {
    Scene scene = test::sceneOf({test::quad(), test::quad()});
    scene.objects[0].transform[3] = {10, 0, 0, 1};
    EXPECT_FLOAT_EQ(boundsOf(scene).maximum.x, 11);
    EXPECT_FLOAT_EQ(boundsOf(scene).minimum.x, -1);
    scene.objects[0].visible = false;
    EXPECT_FLOAT_EQ(boundsOf(scene).maximum.x, 1);
    EXPECT_FLOAT_EQ(boundsOf(Scene{}).radius, 0);
}

}  // namespace
}  // namespace chiaro::scene
