#include "core/scene/gbuffer.h"

#include "tests/core/scene/shapes.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>

namespace chiaro::scene {
namespace {

GBuffer castFront(const Scene& scene, int width, int height) {
    return castGBuffer(RayScene(scene), scene.lights, test::frontCamera(), width, height);
}

glm::vec3 pointOf(const GBuffer& gbuffer, const Scene& scene, int x, int y) {
    const Object& object = scene.objects[gbuffer.objectId(x, y) - 1u];
    const Triangle& triangle = object.mesh->triangles[gbuffer.faceId(x, y)];
    const glm::vec2 weights = gbuffer.barycentrics(x, y);
    const glm::vec3 local = object.mesh->positions[triangle[0]] * (1 - weights.x - weights.y) +
                            object.mesh->positions[triangle[1]] * weights.x +
                            object.mesh->positions[triangle[2]] * weights.y;
    return glm::vec3(object.transform * glm::vec4(local, 1));
}

float coverage(const GBuffer& gbuffer, std::size_t edge) {
    int covered = 0;
    for (int i = 0; i < GBuffer::samplesPerEdge; ++i)
        covered += gbuffer.edgeSamples[edge * GBuffer::samplesPerEdge + std::size_t(i)].object != 0;
    return float(covered) / float(GBuffer::samplesPerEdge);
}

/// Pixels that objects cover, counted finely at the silhouettes.
double coveredArea(const GBuffer& gbuffer) {
    double area = 0;
    for (const std::uint16_t object : gbuffer.objectId.pixels()) area += object != 0;
    for (std::size_t e = 0; e < gbuffer.edgePixels.size(); ++e)
        area += double(coverage(gbuffer, e)) - double(gbuffer.objectId.pixels()[gbuffer.edgePixels[e]] != 0);
    return area;
}

template <class T>
bool sameBytes(std::span<const T> a, std::span<const T> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

void expectSameBytes(const GBuffer& a, const GBuffer& b) {
    EXPECT_TRUE(sameBytes(a.light.pixels(), b.light.pixels()));
    EXPECT_TRUE(sameBytes(a.objectId.pixels(), b.objectId.pixels()));
    EXPECT_TRUE(sameBytes(a.faceId.pixels(), b.faceId.pixels()));
    EXPECT_TRUE(sameBytes(a.barycentrics.pixels(), b.barycentrics.pixels()));
    EXPECT_TRUE(sameBytes(a.depth.pixels(), b.depth.pixels()));
    EXPECT_TRUE(sameBytes(a.normal.pixels(), b.normal.pixels()));
    EXPECT_EQ(a.edgePixels, b.edgePixels);
    EXPECT_EQ(a.edgeSamples, b.edgeSamples);
}

TEST(GBuffer, AQuadFillsExactlyThePixelsInsideItsProjection) {
    const Scene scene = test::sceneOf({test::quad()});
    const Camera camera = test::frontCamera();
    const int size = 64;
    const GBuffer gbuffer = castFront(scene, size, size);
    // At the target's distance the picture is 2 d tan(fov / 2) wide.
    const double half = 32 / (double(camera.eyeDistance()) * std::tan(glm::radians(15.0)));
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const bool inside = std::abs(x + 0.5 - 32) < half && std::abs(y + 0.5 - 32) < half;
            ASSERT_EQ(gbuffer.objectId(x, y), inside ? 1 : 0) << x << " " << y;
            ASSERT_EQ(gbuffer.faceId(x, y) == 0xFFFFFFFF, !inside);
            if (!inside) {
                EXPECT_EQ(gbuffer.light(x, y), -1);
                EXPECT_EQ(gbuffer.depth(x, y), std::numeric_limits<float>::infinity());
                continue;
            }
            EXPECT_NEAR(gbuffer.depth(x, y), camera.eyeDistance(), 1e-5);
            EXPECT_EQ(gbuffer.normal(x, y), glm::vec3(0, 0, 1));
            EXPECT_EQ(gbuffer.faceId(x, y),
                      x + y + 1 < size ? 1u : (x + y + 1 > size ? 0u : gbuffer.faceId(x, y)))
                << "the upper left half is the second face";
        }
    EXPECT_NEAR(coveredArea(gbuffer), 4 * half * half, 4 * half * 0.1);
}

TEST(GBuffer, ProjectingTheHitGivesThePixelCentre) {
    Scene scene = test::sceneOf({test::ball(40, 20)});
    scene.objects[0].transform = glm::mat4(2, 0, 0, 0, 0, 1, 0.5f, 0, 0, 0, 1, 0, 30, 20, 10, 1);
    Camera camera;
    camera.azimuth = 130;
    camera.elevation = -40;
    camera.distance = 0.8f;
    camera = camera.framed(boundsOf(scene));
    const int width = 90;
    const int height = 50;
    const GBuffer gbuffer = castGBuffer(RayScene(scene), scene.lights, camera, width, height);
    int hits = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (gbuffer.objectId(x, y) == 0) continue;
            ++hits;
            const glm::vec4 view = camera.view() * glm::vec4(pointOf(gbuffer, scene, x, y), 1);
            const glm::vec4 clip = camera.projection(width, height) * view;
            ASSERT_NEAR((clip.x / clip.w * 0.5f + 0.5f) * float(width), float(x) + 0.5f, 1e-3);
            ASSERT_NEAR((0.5f - clip.y / clip.w * 0.5f) * float(height), float(y) + 0.5f, 1e-3);
            ASSERT_NEAR(-view.z, gbuffer.depth(x, y), 1e-4f * camera.eyeDistance());
            ASSERT_NEAR(glm::length(gbuffer.normal(x, y)), 1, 1e-5);
        }
    EXPECT_GT(hits, 500);
}

TEST(GBuffer, NormalsAndLightOfATurnedAndStretchedBallAreThoseOfTheSurface) {
    Scene scene = test::sceneOf({test::ball(160, 80)});
    scene.objects[0].transform = glm::mat4(1, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    const GBuffer gbuffer = castFront(scene, 61, 61);
    for (int y = 0; y < 61; ++y)
        for (int x = 0; x < 61; ++x) {
            if (gbuffer.objectId(x, y) == 0) continue;
            const glm::vec3 point = pointOf(gbuffer, scene, x, y);
            const glm::vec3 expected = glm::normalize(glm::vec3(point.x, point.y * 4, point.z));
            if (glm::dot(expected, glm::normalize(test::frontCamera().position() - point)) < 0.05f) continue;
            ASSERT_GT(glm::dot(gbuffer.normal(x, y), expected), 0.999f);
            ASSERT_EQ(gbuffer.light(x, y), lightValue(scene.lights, point, gbuffer.normal(x, y)));
        }
}

TEST(GBuffer, BackSidesAreLitWithTheFlippedNormal) {
    Scene scene = test::sceneOf({test::quad()});
    scene.lights[0].vector = {0, 0, 1};
    const RayScene rays(scene);
    Camera camera = test::frontCamera();
    EXPECT_FLOAT_EQ(castGBuffer(rays, scene.lights, camera, 9, 9).light(4, 4), 1);
    camera.azimuth = 180;
    const GBuffer back = castGBuffer(rays, scene.lights, camera, 9, 9);
    EXPECT_FLOAT_EQ(back.light(4, 4), 0);
    EXPECT_LT(glm::length(back.normal(4, 4) - glm::vec3(0, 0, -1)), 1e-6f);
}

TEST(GBuffer, WindingThatDisagreesWithTheNormalsChangesNothing) {
    Scene scene = test::sceneOf({test::quad()});
    scene.lights[0].vector = {0, 0, 1};
    Mesh inverted = test::quad();
    for (Triangle& triangle : inverted.triangles) std::swap(triangle[1], triangle[2]);
    Scene other = test::sceneOf({inverted});
    other.lights = scene.lights;
    EXPECT_EQ(castFront(scene, 9, 9).light, castFront(other, 9, 9).light);
}

TEST(GBuffer, SilhouetteCoverageMatchesTheDiscsArea) {
    // The ball touches the picture's sides: a disc of diameter 48.
    const GBuffer gbuffer = castFront(test::sceneOf({test::ball(400, 200)}), 48, 48);
    EXPECT_NEAR(coveredArea(gbuffer), M_PI * 24 * 24, 0.002 * M_PI * 24 * 24);
    int partial = 0;
    for (std::size_t e = 0; e < gbuffer.edgePixels.size(); ++e) {
        const float covered = coverage(gbuffer, e);
        partial += covered > 0 && covered < 1;
    }
    EXPECT_GT(partial, 100) << "the silhouette crosses about 8 / pi pixels per pixel of diameter";
}

TEST(GBuffer, AWireThinnerThanAPixelIsSeenAllAlong) {
    Mesh wire = test::quad();
    for (glm::vec3& position : wire.positions)
        position = {position.x * 0.004f + position.y * 0.2f, position.y, 0};
    const GBuffer gbuffer = castFront(test::sceneOf({wire}), 64, 64);
    std::vector<double> perRow(64, 0);
    for (std::size_t e = 0; e < gbuffer.edgePixels.size(); ++e)
        perRow[gbuffer.edgePixels[e] / 64] += double(coverage(gbuffer, e));
    for (std::size_t y = 4; y < 60; ++y)
        EXPECT_NEAR(perRow[y], 0.008 * 32 / std::sqrt(1 - std::pow(std::sin(M_PI / 12), 2)), 0.13);
}

TEST(GBuffer, EdgePixelsAreInRasterOrderAndFarFromFlatInside) {
    const GBuffer gbuffer = castFront(test::sceneOf({test::quad()}), 64, 64);
    EXPECT_TRUE(std::is_sorted(gbuffer.edgePixels.begin(), gbuffer.edgePixels.end()));
    EXPECT_LT(gbuffer.edgePixels.size(), 800u);
    EXPECT_EQ(std::count(gbuffer.edgePixels.begin(), gbuffer.edgePixels.end(), 32u * 64 + 32), 0);
    EXPECT_EQ(gbuffer.edgeSamples.size(), gbuffer.edgePixels.size() * GBuffer::samplesPerEdge);
}

TEST(GBuffer, CoincidentFacesGoToTheSmallerObjectAndFace) {
    Mesh doubled = test::quad();
    const std::vector<Triangle> once = doubled.triangles;
    doubled.triangles.insert(doubled.triangles.end(), once.begin(), once.end());
    const GBuffer gbuffer = castFront(test::sceneOf({doubled, doubled, doubled}), 40, 40);
    for (std::size_t i = 0; i < gbuffer.objectId.pixelCount(); ++i) {
        if (gbuffer.objectId.pixels()[i] == 0) continue;
        ASSERT_EQ(gbuffer.objectId.pixels()[i], 1);
        ASSERT_LT(gbuffer.faceId.pixels()[i], 2u);
    }
}

TEST(GBuffer, HiddenObjectsKeepTheirNumber) {
    Scene scene = test::sceneOf({test::quad(), test::quad()});
    scene.objects[0].visible = false;
    EXPECT_EQ(castFront(scene, 9, 9).objectId(4, 4), 2);
    scene.objects[1].visible = false;
    EXPECT_EQ(castFront(scene, 9, 9).objectId(4, 4), 0);
    EXPECT_EQ(castFront(Scene{}, 1, 1).objectId(0, 0), 0);
}

TEST(GBuffer, NoRaySlipsThroughTheEdgesOfAClosedSurface) {
    const GBuffer gbuffer = castFront(test::sceneOf({test::ball(64, 32)}), 200, 200);
    const float nearest = test::frontCamera().eyeDistance();
    for (const float depth : gbuffer.depth.pixels())
        ASSERT_TRUE(depth < nearest || !std::isfinite(depth)) << "the far side shows";
}

TEST(GBuffer, MeshesFarFromTheOriginAndOfAnySizeLookTheSame) {
    for (const float scale : {1e-6f, 1e6f}) {
        Scene scene = test::sceneOf({test::ball(64, 32)});
        scene.objects[0].transform = glm::mat4(scale);
        scene.objects[0].transform[3] = {100 * scale, 0, 0, 1};
        Camera camera = test::frontCamera();
        camera.target = {100 * scale, 0, 0};
        camera.radius = scale;
        const GBuffer gbuffer = castGBuffer(RayScene(scene), scene.lights, camera, 48, 48);
        EXPECT_NEAR(coveredArea(gbuffer), M_PI * 24 * 24, 0.01 * M_PI * 24 * 24);
        EXPECT_NEAR(gbuffer.depth(24, 24), camera.eyeDistance() - scale, 1e-2 * double(scale));
    }
}

TEST(GBuffer, BytesDoNotDependOnTheThreads) {
    const auto cast = [](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        Scene scene = test::sceneOf({test::ball(100, 50), test::quad(), test::quad()});
        scene.objects[1].transform = glm::mat4(1.2f);
        scene.objects[1].transform[3] = glm::vec4(0.2f, 0, 0, 1);
        scene.objects[2].transform = scene.objects[1].transform;
        Camera camera;
        return castGBuffer(RayScene(scene), scene.lights, camera.framed(boundsOf(scene)), 150, 110);
    };
    expectSameBytes(cast(1), cast(4));
}

TEST(GBuffer, CanBeCancelled) {
    std::stop_source stop;
    stop.request_stop();
    const Scene scene = test::sceneOf({test::quad()});
    EXPECT_THROW(RayScene(scene, Task(stop.get_token())), Cancelled);
    const RayScene rays(scene);
    EXPECT_THROW(castGBuffer(rays, scene.lights, Camera{}, 64, 64, Task(stop.get_token())), Cancelled);
}

}  // namespace
}  // namespace chiaro::scene
