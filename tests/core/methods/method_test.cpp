#include "core/methods/method.h"

#include <gtest/gtest.h>

namespace chiaro::methods {
namespace {

/// Two pixels: the left shows object 1 at full light, the right is an edge that object 2 half covers.
scene::GBuffer twoPixels() {
    scene::GBuffer gbuffer;
    gbuffer.width = 2;
    gbuffer.height = 1;
    gbuffer.light = ScalarImage(2, 1, -1);
    gbuffer.objectId = IdImage(2, 1);
    gbuffer.light(0, 0) = 1;
    gbuffer.objectId(0, 0) = 1;
    gbuffer.edgePixels = {1};
    gbuffer.edgeSamples.resize(scene::GBuffer::samplesPerEdge);
    for (std::size_t i = 0; i < gbuffer.edgeSamples.size() / 2; ++i) gbuffer.edgeSamples[i] = {2, 0.0f};
    return gbuffer;
}

const gradient::Gradient first{{0, 0, 0}, {0.5f, 0.6f, 0.7f}};
const gradient::Gradient second{{0.2f, 0.4f, 0.6f}, {1, 1, 1}};

TEST(Shade, AddsTextureToTheGradientAndClips) {
    const Frame frame = shade(twoPixels(), {&first, &second},
                              [](auto, int, int, float) { return glm::vec3(0.1f, 0.9f, -0.9f); });
    EXPECT_FLOAT_EQ(frame.picture(0, 0).r, 0.6f);
    EXPECT_FLOAT_EQ(frame.picture(0, 0).g, 1);
    EXPECT_FLOAT_EQ(frame.picture(0, 0).b, 0);
    EXPECT_FLOAT_EQ(frame.picture(0, 0).a, 1);
    EXPECT_EQ(frame.texture(0, 0), glm::vec3(0.1f, 0.9f, -0.9f));
}

TEST(Shade, AnEdgePixelIsCoveredByTheShareOfItsSamples) {
    const Frame frame =
        shade(twoPixels(), {&first, &second}, [](auto, int, int, float) { return glm::vec3(0); });
    EXPECT_FLOAT_EQ(frame.picture(1, 0).a, 0.5f);
    EXPECT_FLOAT_EQ(frame.picture(1, 0).r, 0.2f);
    EXPECT_FLOAT_EQ(frame.picture(1, 0).b, 0.6f);
    const ColorImage onWhite = over(frame.picture, glm::vec3(1));
    EXPECT_FLOAT_EQ(onWhite(1, 0).r, 0.6f);
}

TEST(Shade, StopsWhenCancelled) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(shade(
                     twoPixels(), {&first, &second}, [](auto, int, int, float) { return glm::vec3(0); },
                     Task(stop.get_token())),
                 Cancelled);
}

}  // namespace
}  // namespace chiaro::methods
