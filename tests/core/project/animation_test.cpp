#include "core/project/animation.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/scene/motion.h"
#include "tests/core/scene/shapes.h"
#include "tests/support/support.h"

#include <tbb/global_control.h>

namespace chiaro::project {
namespace {

using methods::Coherence;

/// Soft spots of random grey on a ramp from dark to light.
Paint spottedPaint() {
    Paint paint;
    paint.separation.texture = ColorImage(240, 60, glm::vec3(0.01f));  // nowhere 0
    Random random(3);
    for (int spot = 0; spot < 900; ++spot) {
        const glm::vec2 centre(random.uniform() * 240, random.uniform() * 60);
        const float strength = 0.3f * (float(random.uniform()) - 0.5f);
        for (int y = int(centre.y) - 4; y <= int(centre.y) + 4; ++y)
            for (int x = int(centre.x) - 4; x <= int(centre.x) + 4; ++x) {
                if (!paint.separation.texture.contains(x, y)) continue;
                const glm::vec2 from = glm::vec2(x, y) - centre;
                paint.separation.texture(x, y) += glm::vec3(strength * std::exp(-glm::dot(from, from) / 5));
            }
    }
    paint.separation.gradient.assign(240, glm::vec3(0.5f));
    paint.strip = paint.separation.texture;
    for (glm::vec3& pixel : paint.strip.pixels()) pixel += 0.5f;
    for (int x = 0; x < 240; ++x) paint.shown.push_back(glm::vec3(0.2f + 0.6f * float(x) / 239));
    paint.levels.levels.assign(4, ColorImage(32, 32));
    for (std::size_t i = 0; i < 4; ++i)
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                paint.levels.levels[i](x, y) = paint.separation.texture(x + 40 * int(i), y);
    return paint;
}

/// A ball that a shot goes around.
class Stage {
public:
    explicit Stage(Coherence coherence, const std::string& method = "image-based", int pixels = 96)
        : m_scene(test::sceneOf({test::ball(64, 32)})), m_paints{spottedPaint()} {
        m_project.method = method;
        m_project.imageBased.quilt.block = m_project.levels.quilt.block = 16;
        m_project.levels.count = 4;
        m_project.views.size = pixels;
        m_worn = wornPaints(m_project, m_scene, m_paints);
        m_project.coherence.mode = coherence;
        m_project.coherence.every = 8;
        m_shot = std::make_unique<Shot>(
            Shot{m_project, m_scene, m_worn, scene::Path::turntable(24), pixels, pixels});
        m_views = std::make_unique<ShotViews>(*m_shot);
    }

    Project& project() { return m_project; }
    const Shot& shot() const { return *m_shot; }
    ShotViews& views() { return *m_views; }
    std::unique_ptr<FramePainter> painter() { return framePainter(*m_shot, *m_views); }
    methods::Frame frame(int number) { return painter()->paint(number, {}).frame; }

private:
    Project m_project;
    scene::Scene m_scene;
    std::vector<Paint> m_paints;
    WornPaints m_worn;
    std::unique_ptr<Shot> m_shot;
    std::unique_ptr<ShotViews> m_views;
};

struct Way {
    const char* method;
    Coherence coherence;
    methods::Reprojection reproject = methods::Reprojection::Keyframes;
};

class EveryWay : public testing::TestWithParam<Way> {};

TEST_P(EveryWay, AFrameIsTheSameWhateverWasPaintedBefore) {
    Stage stage(GetParam().coherence, GetParam().method, 64);
    stage.project().coherence.reproject = GetParam().reproject;
    const auto painter = stage.painter();
    std::map<int, ColorAlphaImage> whole;
    for (int frame = 1; frame <= 11; ++frame) whole[frame] = painter->paint(frame, {}).frame.picture;
    for (const int frame : {5, 9, 11})
        EXPECT_EQ(stage.frame(frame).picture, whole[frame]) << "frame " << frame << " by itself";
    EXPECT_EQ(painter->paint(4, {}).frame.picture, whole[4]) << "going back";
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(stage.frame(6).picture, whole[6]) << "on one thread";
}

TEST_P(EveryWay, FrameOneIsThePictureOfTheProject) {
    Stage stage(GetParam().coherence, GetParam().method, 64);
    if (stage.project().coherence.mode == Coherence::Keyframes && stage.project().method == "image-based")
        stage.project().coherence.every = 1;  // a longer keyframe reaches over more than the first frame
    const methods::FrameView view = stage.views().at(1);
    EXPECT_EQ(stage.frame(1).picture,
              renderFrame(stage.project(), stage.shot().worn, *view.gbuffer).frame.picture);
}

INSTANTIATE_TEST_SUITE_P(
    Ways, EveryWay,
    testing::Values(Way{"image-based", Coherence::Independent}, Way{"image-based", Coherence::Previous},
                    Way{"image-based", Coherence::Keyframes}, Way{"image-based", Coherence::Reprojected},
                    Way{"image-based", Coherence::Reprojected, methods::Reprojection::Previous},
                    Way{"view-aligned", Coherence::Independent},
                    Way{"view-dependent", Coherence::Independent}));

TEST(Animation, EveryPixelOfTheObjectHasTexture) {
    for (const Coherence coherence : {Coherence::Keyframes, Coherence::Reprojected}) {
        Stage stage(coherence);
        for (const int frame : {1, 4, 8}) {
            const methods::Frame painted = stage.frame(frame);
            const auto gbuffer = stage.views().at(frame).gbuffer;
            int bare = 0;
            for (std::size_t i = 0; i < gbuffer->objectId.pixelCount(); ++i)
                bare += gbuffer->objectId.pixels()[i] != 0 && painted.texture.pixels()[i] == glm::vec3(0);
            EXPECT_EQ(bare, 0) << "frame " << frame;
        }
    }
}

/// How much the texture changes from one frame to the next, where the picture or the object stays.
struct Change {
    double image = 0;
    double object = 0;
};

Change changeOver(Coherence coherence, const std::string& method = "image-based") {
    Stage stage(coherence, method);
    const auto painter = stage.painter();
    Change change;
    std::size_t imagePixels = 0, objectPixels = 0;
    ColorImage before = painter->paint(1, {}).frame.texture;
    for (int frame = 1; frame < 24; ++frame) {
        const methods::FrameView here = stage.views().at(frame), there = stage.views().at(frame + 1);
        const ColorImage after = painter->paint(frame + 1, {}).frame.texture;
        const auto seen = scene::seenFrom(*here.gbuffer, here.camera, there.camera);
        for (int y = 0; y < after.height(); ++y)
            for (int x = 0; x < after.width(); ++x) {
                if (here.gbuffer->objectId(x, y) == 0) continue;
                const auto squared = [&](glm::vec3 other) {
                    const glm::vec3 difference = other - before(x, y);
                    return double(glm::dot(difference, difference));
                };
                if (there.gbuffer->objectId(x, y) != 0) {
                    change.image += squared(after(x, y));
                    ++imagePixels;
                }
                const glm::ivec2 at(glm::floor(seen(x, y).position));
                if (seen(x, y).facing < 0.2f || !after.contains(at.x, at.y)) continue;
                change.object += squared(after(at.x, at.y));
                ++objectPixels;
            }
        before = after;
    }
    return {change.image / double(imagePixels), change.object / double(objectPixels)};
}

TEST(Coherence, ChangeFallsFromModeToMode) {
    const Change independent = changeOver(Coherence::Independent);
    const Change previous = changeOver(Coherence::Previous);
    const Change keyframes = changeOver(Coherence::Keyframes);
    const Change reprojected = changeOver(Coherence::Reprojected);
    EXPECT_LT(previous.image, 0.8 * independent.image);
    EXPECT_LT(keyframes.image, 0.8 * previous.image);
    for (const Change& other : {independent, previous, keyframes})
        EXPECT_LT(reprojected.object, 0.6 * other.object);
    std::printf("mean squared change  image space, object space\n");
    for (const auto& [name, change] :
         std::vector<std::pair<const char*, Change>>{{"independent", independent},
                                                     {"previous", previous},
                                                     {"keyframes", keyframes},
                                                     {"reprojected", reprojected}})
        std::printf("  %-12s %.6f %.6f\n", name, change.image, change.object);
}

TEST(Coherence, OnTheObjectIsBestWithViewDependentTextures) {
    const Change imageBased = changeOver(Coherence::Independent);
    const Change viewAligned = changeOver(Coherence::Independent, "view-aligned");
    const Change viewDependent = changeOver(Coherence::Independent, "view-dependent");
    EXPECT_LT(viewDependent.object, 0.2 * imageBased.object);
    EXPECT_LT(viewDependent.object, 0.2 * viewAligned.object);
    std::printf(
        "mean squared change on the object: image-based %.6f, view-aligned %.6f, view-dependent %.6f\n",
        imageBased.object, viewAligned.object, viewDependent.object);
}

TEST(Coherence, PreservingKeepsTheContrastHalfWay) {
    const auto contrast = [](methods::Blend blend, int frame) {
        Stage stage(Coherence::Keyframes);
        stage.project().coherence.blend = blend;
        const methods::Frame painted = stage.frame(frame);
        double sum = 0;
        std::size_t count = 0;
        const auto gbuffer = stage.views().at(frame).gbuffer;
        for (std::size_t i = 0; i < painted.texture.pixelCount(); ++i) {
            if (gbuffer->objectId.pixels()[i] == 0) continue;
            sum += double(glm::dot(painted.texture.pixels()[i], painted.texture.pixels()[i]));
            ++count;
        }
        return std::sqrt(sum / double(count));
    };
    const double atKey = contrast(methods::Blend::Linear, 1);
    EXPECT_NEAR(contrast(methods::Blend::Linear, 5) / atKey, 0.71, 0.1);
    EXPECT_NEAR(contrast(methods::Blend::Preserving, 5) / atKey, 1, 0.12);
}

TEST(PlanObject, GivesSmallerObjectsSmallerMapsSoThatStrokesAreOfOneSize) {
    Project project;
    project.views.size = 256;
    project.views.count = 4;
    scene::Scene scene = test::sceneOf({test::ball(16, 8), test::ball(16, 8), test::ball(16, 8)});
    scene.objects[1].transform = glm::mat4(glm::mat3(0.5f));
    scene.objects[2].transform = glm::mat4(glm::mat3(0.01f));
    const auto sizeOf = [&](std::size_t object) {
        return planObject(project, scene, object)->plan.groups.front().view.size;
    };
    EXPECT_EQ(sizeOf(0), 256);
    EXPECT_EQ(sizeOf(1), 128);
    EXPECT_EQ(sizeOf(2), 64);  // not less
}

TEST(ReadPath, TakesKeysOfCameraAndLight) {
    const test::TemporaryFolder folder;
    writeFileAtomically(folder / "a.json", R"({"path": 1, "interpolation": "linear", "keys": [
        {"frame": 1, "azimuth": 0, "light": [1, 0, 0]}, {"frame": 3, "azimuth": 90, "target": [1, 2, 3]}]})");
    const scene::Path path = readPath(folder / "a.json");
    const scene::View view = path.at(2, {scene::Camera{.elevation = 7}, {scene::Light{}}});
    EXPECT_FLOAT_EQ(view.camera.azimuth, 45);
    EXPECT_FLOAT_EQ(view.camera.elevation, 7);
    EXPECT_EQ(view.camera.target, glm::vec3(1, 2, 3));
    EXPECT_EQ(view.lights.front().vector, glm::vec3(1, 0, 0));
}

TEST(ReadPath, SaysWhatIsWrong) {
    const test::TemporaryFolder folder;
    for (const auto& [text, complaint] : std::vector<std::pair<const char*, const char*>>{
             {"[", "is not JSON"},
             {"[]", "is not an object"},
             {"{}", "has no \"path\""},
             {R"({"path": 2, "keys": []})", "path: is 2"},
             {R"({"path": 1, "keys": []})", "at least one key"},
             {R"({"path": 1, "keys": [{"azimuth": 3}]})", "has no \"frame\""},
             {R"({"path": 1, "keys": [{"frame": 3}, {"frame": 3}]})", "in the order of their frames"},
             {R"({"path": 1, "keys": [{"frame": 3, "light": [0, 0, 0]}]})", "not zero"},
             {R"({"path": 1, "keys": [{"frame": 3, "elevation": 100}]})", "-90 to 90"},
             {R"({"path": 1, "interpolation": "bezier", "keys": [{"frame": 3}]})",
              "\"smooth\" or \"linear\""}}) {
        writeFileAtomically(folder / "a.json", text);
        try {
            readPath(folder / "a.json");
            ADD_FAILURE() << text;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(complaint), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace chiaro::project
