#include "core/methods/coherence.h"

#include "core/methods/carried_texture.h"
#include "tests/core/scene/shapes.h"

#include <gtest/gtest.h>

namespace chiaro::methods {
namespace {

TEST(Blend, LinearAveragesAndPreservingKeepsTheVarianceOfUnrelatedTextures) {
    const glm::vec3 a(0.4f, 0, -0.2f), b(0, 0.3f, 0.2f);
    EXPECT_EQ(blended(Blend::Linear, a, 1, b, 0), a);
    EXPECT_EQ(blended(Blend::Preserving, a, 1, b, 0), a);
    EXPECT_NEAR(glm::distance(blended(Blend::Linear, a, 1, b, 3), 0.25f * a + 0.75f * b), 0, 1e-6);
    EXPECT_NEAR(glm::distance(blended(Blend::Preserving, a, 1, b, 1), (a + b) / std::sqrt(2.0f)), 0, 1e-6);
    EXPECT_EQ(blended(Blend::Preserving, a, 0, b, 0), glm::vec3(0));
}

ObjectGuide guideOf(glm::ivec2 origin, int width, int height) {
    return {origin, Image<std::uint8_t>(width, height, 1), ScalarImage(width, height, 0.5f)};
}

TEST(ObjectGuide, ExtendingKeepsItsOwnLightAndTakesTheRestFromTheOther) {
    ObjectGuide guide = guideOf({10, 10}, 2, 2);
    ObjectGuide other = guideOf({11, 8}, 3, 3);
    for (float& light : other.light.pixels()) light = 0.25f;
    extend(guide, other);
    EXPECT_EQ(guide.origin, glm::ivec2(10, 8));
    EXPECT_EQ(guide.covered.width(), 4);
    EXPECT_EQ(guide.covered.height(), 4);
    EXPECT_EQ(guide.light(1, 2), 0.5f);   // (11, 10): in both
    EXPECT_EQ(guide.light(3, 0), 0.25f);  // (13, 8): in the other alone
    EXPECT_FALSE(guide.covered(0, 0));    // (10, 8): in neither
    ObjectGuide empty;
    extend(empty, other);
    EXPECT_EQ(empty.covered, other.covered);
    extend(empty, {});
    EXPECT_EQ(empty.covered, other.covered);
}

TEST(CarriedTexture, StaysWhereItIsInThePicture) {
    ObjectTexture texture{{5, 5}, ColorImage(4, 4), synthesis::PixelMask(4, 4, 1)};
    for (int i = 0; i < 16; ++i) texture.pixels(i % 4, i / 4) = glm::vec3(float(i));
    texture.covered(3, 3) = 0;
    const CarriedTexture carried = stayed(texture, guideOf({7, 7}, 3, 2));
    EXPECT_EQ(carried.pixels(0, 0), glm::vec3(10));  // (7, 7) is (2, 2) there
    EXPECT_EQ(carried.confidence(0, 0), 1);
    EXPECT_EQ(carried.confidence(1, 1), 0);  // (8, 8) isn't covered there
    EXPECT_EQ(carried.confidence(2, 0), 0);  // beyond it
}

/// A ball whose texture tells where on the ball it is: red is the world's x, green its y.
FrameTexture tellingBall(float azimuth, int size) {
    const scene::Scene scene = test::sceneOf({test::ball(96, 48)});
    FrameTexture frame;
    frame.view.camera = test::frontCamera();
    frame.view.camera.azimuth = azimuth;
    frame.view.gbuffer = std::make_shared<const scene::GBuffer>(
        scene::castGBuffer(scene::RayScene(scene), scene.lights, frame.view.camera, size, size));
    const scene::GBuffer& gbuffer = *frame.view.gbuffer;
    ObjectTexture texture{{0, 0}, gbuffer.normal, synthesis::PixelMask(size, size)};
    for (std::size_t i = 0; i < gbuffer.objectId.pixelCount(); ++i)
        texture.covered.pixels()[i] = gbuffer.objectId.pixels()[i] != 0;
    frame.texture.objects.push_back(std::move(texture));
    return frame;
}

TEST(CarriedTexture, MovesWithTheSurface) {
    constexpr int size = 120;
    const FrameTexture from = tellingBall(0, size), to = tellingBall(25, size);
    const scene::GBuffer& gbuffer = *to.view.gbuffer;
    const ObjectGuide guide = objectGuides(gbuffer, 1).front();
    const CarriedTexture carried =
        moved(from, 0, guide, gbuffer, scene::seenFrom(gbuffer, to.view.camera, from.view.camera));
    int known = 0, unknown = 0;
    for (int y = 0; y < guide.covered.height(); ++y)
        for (int x = 0; x < guide.covered.width(); ++x) {
            const glm::ivec2 pixel = guide.origin + glm::ivec2(x, y);
            if (gbuffer.objectId(pixel.x, pixel.y) == 0) continue;
            const glm::vec3 point = gbuffer.normal(pixel.x, pixel.y);
            const bool turnedAway = point.z < 0.2f;  // from the camera at azimuth 0, which looks past the rim
            if (turnedAway) {
                EXPECT_EQ(carried.confidence(x, y), 0) << x << " " << y;
                ++unknown;
            } else if (point.z > 0.4f) {
                ASSERT_GT(carried.confidence(x, y), 0) << x << " " << y;
                EXPECT_LT(glm::distance(carried.pixels(x, y), point), 0.02f);
                ++known;
            }
        }
    EXPECT_GT(known, 4000);
    EXPECT_GT(unknown, 300);
}

TEST(CarriedTexture, IsUnknownWhereSomethingStoodBefore) {
    // A quad before a larger one: from the side, what the near one hid comes to light.
    scene::Mesh far = test::quad();
    for (glm::vec3& position : far.positions) position = position * 3.0f - glm::vec3(0, 0, 2);
    const scene::Scene scene = test::sceneOf({far, test::quad()});
    const scene::RayScene rays(scene);
    scene::Camera front = test::frontCamera();
    front.radius = 3;
    scene::Camera side = front;
    side.azimuth = 25;
    FrameTexture from;
    from.view = {
        std::make_shared<const scene::GBuffer>(scene::castGBuffer(rays, scene.lights, front, 100, 100)),
        front};
    for (const ObjectGuide& guide : objectGuides(*from.view.gbuffer, 2))
        from.texture.objects.push_back(
            {guide.origin, ColorImage(guide.covered.width(), guide.covered.height(), glm::vec3(0.5f)),
             guide.covered});
    const scene::GBuffer gbuffer = scene::castGBuffer(rays, scene.lights, side, 100, 100);
    const auto guides = objectGuides(gbuffer, 2);
    const CarriedTexture carried = moved(from, 0, guides[0], gbuffer, scene::seenFrom(gbuffer, side, front));
    int known = 0, unknown = 0;
    for (int y = 0; y < guides[0].covered.height(); ++y)
        for (int x = 0; x < guides[0].covered.width(); ++x) {
            const glm::ivec2 pixel = guides[0].origin + glm::ivec2(x, y);
            if (gbuffer.objectId(pixel.x, pixel.y) != 1) continue;
            ++(carried.confidence(x, y) > 0 ? known : unknown);
        }
    EXPECT_GT(known, 500);
    EXPECT_GT(unknown, 100);
}

}  // namespace
}  // namespace chiaro::methods
