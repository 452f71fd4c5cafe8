#include "core/scene/path.h"

#include <gtest/gtest.h>

namespace chiaro::scene {
namespace {

View start() {
    View view{Camera{}, {Light{}}};
    view.camera.azimuth = 30;
    view.lights.front().vector = {1, 2, 0};
    return view;
}

TEST(Path, ATurntableGoesAroundOnceAndTouchesNothingElse) {
    const Path path = Path::turntable(24);
    EXPECT_EQ(path.at(1, start()).camera, start().camera);
    EXPECT_FLOAT_EQ(path.at(7, start()).camera.azimuth, 120);
    EXPECT_FLOAT_EQ(path.at(25, start()).camera.azimuth, 390);
    EXPECT_EQ(path.at(7, start()).lights, start().lights);
}

TEST(Path, ALightSweepTurnsEveryLightAroundTheVerticalAxis) {
    View view = start();
    view.lights.push_back(Light{.vector = {0, 1, 0}});
    const View quarter = Path::lightSweep(8).at(3, view);
    EXPECT_NEAR(glm::distance(quarter.lights[0].vector, glm::vec3(0, 2, -1)), 0, 1e-6);
    EXPECT_NEAR(glm::distance(quarter.lights[1].vector, glm::vec3(0, 1, 0)), 0, 1e-6);
    EXPECT_EQ(quarter.camera, view.camera);
}

TEST(Path, AnApproachComesNearerByTheSameShareEachFrame) {
    const Path path = Path::approaching();
    EXPECT_EQ(path.at(1, start()).camera, start().camera);
    EXPECT_FLOAT_EQ(path.at(3, start()).camera.distance, 0.96f * 0.96f);
    EXPECT_FLOAT_EQ(path.at(999, start()).camera.distance, 0.01f);
    EXPECT_FLOAT_EQ(path.at(3, start()).camera.azimuth, 30);
}

TEST(Path, ChannelsPassThroughTheirKeysAndRestBeyondThem) {
    for (const bool smooth : {false, true}) {
        Path path;
        path.smooth = smooth;
        path.elevation.keys = {{3, -10}, {5, 20}, {9, 20}, {11, 0}};
        for (const auto& [frame, value] : std::vector<std::pair<double, float>>{
                 {1, -10}, {3, -10}, {5, 20}, {7, 20}, {9, 20}, {11, 0}, {99, 0}})
            EXPECT_FLOAT_EQ(path.at(frame, start()).camera.elevation, value) << frame;
        EXPECT_FLOAT_EQ(path.at(4, start()).camera.elevation, 5);
        EXPECT_FLOAT_EQ(path.at(4, start()).camera.azimuth, 30);
    }
}

TEST(Path, SmoothChannelsNeverOvershoot) {
    Channel channel;
    channel.keys = {{1, 0}, {2, 10}, {3, 10.5}, {10, 11}, {11, 0}};
    for (double frame = 1; frame <= 11; frame += 0.1) {
        const double value = channel.at(frame, true);
        EXPECT_GE(value, -1e-9);
        EXPECT_LE(value, 11 + 1e-9);
    }
}

TEST(Path, ALightThatPassesThroughNothingKeepsADirection) {
    Path path;
    path.smooth = false;
    path.light[0].keys = {{1, 1}, {3, -1}};
    path.light[1].keys = path.light[2].keys = {{1, 0}};
    EXPECT_EQ(path.at(1, start()).lights.front().vector, glm::vec3(1, 0, 0));
    EXPECT_EQ(path.at(2, start()).lights.front().vector, start().lights.front().vector);
}

TEST(Path, KeysAreSetMovedAndRemoved) {
    using Part = Path::Part;
    Path path;
    EXPECT_FALSE(path.moves());
    path.setKey(10, start().camera);
    path.setKey(5, glm::vec3(1, 2, 3));
    path.setKey(10, glm::vec3(3, 2, 1));
    EXPECT_TRUE(path.moves());
    EXPECT_EQ(path.keyFrames(Part::Camera), std::vector<int>{10});
    EXPECT_EQ(path.keyFrames(Part::Light), (std::vector<int>{5, 10}));
    path.moveKey(Part::Light, 5, 10);
    EXPECT_EQ(path.keyFrames(Part::Light), std::vector<int>{10});
    EXPECT_EQ(path.at(10, start()).lights.front().vector, glm::vec3(1, 2, 3)) << "it took the other's place";
    EXPECT_EQ(path.at(77, start()).camera, start().camera);
    path.removeKey(Part::Light, 10);
    path.removeKey(Part::Camera, 10);
    EXPECT_EQ(path, Path{});
}

TEST(Path, APointLightGoesAroundTheTarget) {
    View view = start();
    view.camera.target = {10, 0, 0};
    view.lights = {{.kind = Light::Kind::Point, .vector = {11, 5, 0}}};
    EXPECT_NEAR(glm::distance(Path::lightSweep(8).at(3, view).lights[0].vector, glm::vec3(10, 5, -1)), 0,
                1e-5);
}

}  // namespace
}  // namespace chiaro::scene
