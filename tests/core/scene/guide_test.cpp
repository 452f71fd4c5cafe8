#include "core/scene/guide.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace chiaro::scene {
namespace {

TEST(Guide, ValuesThatAreNoLightAreOutside) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float values[] = {0, 0.5f, 1, 1.5f, -1, -0.0f, nan, infinity, -infinity};
    ScalarImage light(9, 1);
    std::copy(std::begin(values), std::end(values), light.pixels().begin());
    const GBuffer gbuffer = gbufferFromGuide(light);
    const std::vector<std::uint16_t> ids{1, 1, 1, 1, 0, 1, 0, 0, 0};
    const std::vector<float> lights{0, 0.5f, 1, 1, -1, 0, -1, -1, -1};
    EXPECT_TRUE(std::ranges::equal(gbuffer.objectId.pixels(), ids));
    EXPECT_TRUE(std::ranges::equal(gbuffer.light.pixels(), lights));
    EXPECT_TRUE(gbuffer.edgePixels.empty());
}

TEST(Guide, IdsTellTheObjects) {
    IdImage ids(2, 1);
    ids(1, 0) = 700;
    const GBuffer gbuffer = gbufferFromGuide(ScalarImage(2, 1, 0.5f), &ids);
    EXPECT_EQ(gbuffer.objectId, ids);
    EXPECT_EQ(gbuffer.light(0, 0), -1);
}

TEST(Guide, RefusesPicturesThatDoNotFit) {
    const IdImage narrow(3, 4);
    EXPECT_THROW(gbufferFromGuide(ScalarImage()), Error);
    EXPECT_THROW(gbufferFromGuide(ScalarImage(4, 4), &narrow), Error);
}

}  // namespace
}  // namespace chiaro::scene
