#include "core/scene/scene.h"

#include "core/scene/placement.h"

#include <gtest/gtest.h>

namespace chiaro::scene {
namespace {

TEST(Light, APointLightShinesFromWhereItStands) {
    const Light light{.kind = Light::Kind::Point, .vector = {0, 3, 4}, .intensity = 0.5f, .wrap = false};
    EXPECT_EQ(light.direction({0, 0, 0}), glm::vec3(0, 0.6f, 0.8f));
    EXPECT_FLOAT_EQ(light.distance({0, 0, 0}), 5);
    EXPECT_FLOAT_EQ(lightValue({light}, {0, 0, 0}, {0, 1, 0}), 0.3f);
    EXPECT_FLOAT_EQ(lightValue({light}, {0, 0, 0}, {0, -1, 0}), 0);
    EXPECT_FLOAT_EQ(lightValue({light}, {0, 6, 4}, {0, -1, 0}), 0.5f) << "from the other side";
    EXPECT_FLOAT_EQ(lightValue({light}, light.vector, {0, 1, 0}), 0) << "where it stands";
}

TEST(Light, LightsAddUpToOneAndHiddenOnesGiveNothing) {
    const Light soft{.vector = {0, 0, 2}, .intensity = 0.5f};
    Light hard{.vector = {0, 1, 0}, .intensity = 0.4f, .wrap = false};
    const glm::vec3 normal(0, 1, 0);
    EXPECT_FLOAT_EQ(lightValue({soft, hard}, {}, normal), 0.25f + 0.4f);
    EXPECT_FLOAT_EQ(lightValue({soft, hard, hard, hard}, {}, normal), 1);
    hard.visible = false;
    EXPECT_FLOAT_EQ(lightValue({soft, hard}, {}, normal), 0.25f);
    EXPECT_FLOAT_EQ(lightValue({}, {}, normal), 0);
}

glm::vec3 placed(const Placement& placement, glm::vec3 point) {
    return glm::vec3(placement.matrix({1, 2, 3}) * glm::vec4(point, 1));
}

TEST(Placement, MovesTurnsAndScalesAboutTheCentre) {
    EXPECT_EQ(Placement{}.matrix({1, 2, 3}), glm::mat4(1));
    EXPECT_EQ(placed({.position = {1, 0, 0}}, {1, 2, 3}), glm::vec3(2, 2, 3));
    EXPECT_EQ(placed({.scale = {2, 2, 2}}, {1, 2, 3}), glm::vec3(1, 2, 3));
    EXPECT_EQ(placed({.scale = {2, 3, 4}}, {2, 3, 4}), glm::vec3(3, 5, 7));
    const glm::vec3 turned = placed({.position = {0, 0, 1}, .rotation = {0, 0, 90}}, {2, 2, 3});
    EXPECT_NEAR(glm::distance(turned, glm::vec3(1, 3, 4)), 0, 1e-6);
}

TEST(Placement, TurnsAroundXFirst) {
    // (0, 1, 0) around x by 90 is (0, 0, 1), which around y by 90 is (1, 0, 0).
    const glm::vec3 turned = placed({.rotation = {90, 90, 0}}, {1, 3, 3});
    EXPECT_NEAR(glm::distance(turned, glm::vec3(2, 2, 3)), 0, 1e-6);
}

}  // namespace
}  // namespace chiaro::scene
