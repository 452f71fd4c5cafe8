#include "core/methods/image_based.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/sample/strip.h"
#include "core/scene/guide.h"
#include "tests/core/synthesis/textures.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <set>

namespace chiaro::methods {
namespace {

using scene::GBuffer;
using scene::gbufferFromGuide;

/// A strip whose pixels tell where they came from: red is the column, green the row, blue a number of its
/// own.
ColorImage tellingStrip(int width, int height, float own = 0) {
    ColorImage strip(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) strip(x, y) = {float(x) / 1024, float(y) / 1024, own};
    return strip;
}

int columnOf(glm::vec3 texel) {
    return int(std::lround(texel.r * 1024));
}

ColorImage noise(int width, int height) {
    ColorImage image(width, height);
    Random random(7, 0);
    for (glm::vec3& pixel : image.pixels())
        for (int channel = 0; channel < 3; ++channel) pixel[channel] = float(random.uniform()) - 0.5f;
    return image;
}

/// A ball on nothing, lit from the upper left.
ScalarImage ballLight(int size) {
    ScalarImage light(size, size, -1.0f);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::vec2 p = (glm::vec2(x, y) + 0.5f) / float(size) * 2.2f - 1.1f;
            if (glm::dot(p, p) >= 1) continue;
            const glm::vec3 normal(p.x, -p.y, std::sqrt(1 - glm::dot(p, p)));
            light(x, y) = 0.5f + 0.5f * glm::dot(normal, glm::normalize(glm::vec3(-1, 1, 1)));
        }
    return light;
}

ImageBasedParams small(int block = 8, int window = 4, bool draft = false) {
    ImageBasedParams params;
    params.quilt.block = block;
    params.window = window;
    params.draft = draft;
    return params;
}

TEST(Window, LiesAroundTheLightsPlaceAndIsClampedInsideTheStrip) {
    const ColorImage strip(200, 40);
    // Centres within 2 * 10 px of 0.5 * 200: positions 75..115.
    EXPECT_EQ(windowAround(0.5, 2, 10, strip), (synthesis::CandidateArea{75, 0, 41, 31}));
    EXPECT_EQ(windowAround(0, 2, 10, strip), (synthesis::CandidateArea{0, 0, 16, 31}));
    EXPECT_EQ(windowAround(1, 2, 10, strip), (synthesis::CandidateArea{175, 0, 16, 31}));
    EXPECT_EQ(windowAround(0.5, 64, 10, strip), (synthesis::CandidateArea{0, 0, 191, 31}));
}

TEST(Window, OfNoBlocksIsTheNearestPosition) {
    const ColorImage strip(200, 40);
    EXPECT_EQ(windowAround(0.5, 0, 10, strip), (synthesis::CandidateArea{95, 0, 1, 31}));
    EXPECT_EQ(windowAround(0.501, 0, 10, strip), (synthesis::CandidateArea{95, 0, 1, 31}));
    EXPECT_EQ(windowAround(0, 0, 10, strip), (synthesis::CandidateArea{0, 0, 1, 31}));
    EXPECT_EQ(windowAround(1, 0, 10, strip), (synthesis::CandidateArea{190, 0, 1, 31}));
}

class ConstantGuide : public testing::TestWithParam<std::tuple<float, int, bool>> {};

TEST_P(ConstantGuide, UsesOnlySourceBlocksWithinTheWindow) {
    const auto [light, window, draft] = GetParam();
    const ColorImage strip = tellingStrip(300, 40);
    const GBuffer gbuffer = gbufferFromGuide(ScalarImage(70, 50, light));
    const ImageBasedTexture texture = synthesizeImageBased(gbuffer, {&strip}, small(8, window, draft));
    const synthesis::CandidateArea area = windowAround(double(light), window, 8, strip);
    ASSERT_EQ(texture.objects.at(0).pixels.width(), 70);
    std::set<int> columns;
    for (const glm::vec3& texel : texture.objects[0].pixels.pixels()) columns.insert(columnOf(texel));
    EXPECT_GE(*columns.begin(), area.x);
    EXPECT_LE(*columns.rbegin(), area.x + area.width - 1 + 8 - 1);
    EXPECT_GE(columns.size(), 6u);  // all of a block but its overlap
}

INSTANTIATE_TEST_SUITE_P(LightsAndWindows, ConstantGuide,
                         testing::Combine(testing::Values(0.0f, 0.3f, 1.0f), testing::Values(0, 1, 4),
                                          testing::Bool()));

class BothSearches : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(ExactAndDraft, BothSearches, testing::Bool());

TEST_P(BothSearches, NothingToPaintGivesNothing) {
    const ColorImage strip = tellingStrip(100, 40);
    const GBuffer outside = gbufferFromGuide(ScalarImage(20, 20, std::nanf("")));
    const ImageBasedTexture texture = synthesizeImageBased(outside, {&strip}, small(8, 4, GetParam()));
    EXPECT_TRUE(texture.objects.at(0).pixels.empty());
    EXPECT_EQ(texture.report.blocks, 0u);
    const gradient::Gradient gradient{{0, 0, 0}, {1, 1, 1}};
    const Frame frame = shadeImageBased(outside, {&gradient}, texture);
    EXPECT_TRUE(std::ranges::all_of(frame.picture.pixels(), [](glm::vec4 p) { return p == glm::vec4(0); }));
}

TEST_P(BothSearches, ASampleSmallerThanABlockAndABlockLargerThanThePictureFill) {
    const ColorImage tiny = tellingStrip(9, 5, 0.5f);
    const ColorImage strip = tellingStrip(300, 80, 0.5f);
    const GBuffer gbuffer = gbufferFromGuide(ScalarImage(20, 15, 0.5f));
    for (const ColorImage* sample : {&tiny, &strip}) {
        const ImageBasedTexture texture = synthesizeImageBased(gbuffer, {sample}, small(64, 4, GetParam()));
        for (const glm::vec3& texel : texture.objects.at(0).pixels.pixels()) EXPECT_EQ(texel.b, 0.5f);
    }
    const ColorImage pixel(1, 1, glm::vec3(0.25f));
    const ImageBasedTexture texture = synthesizeImageBased(gbuffer, {&pixel}, small(8, 4, GetParam()));
    for (const glm::vec3& texel : texture.objects.at(0).pixels.pixels()) EXPECT_EQ(texel, glm::vec3(0.25f));
}

TEST_P(BothSearches, LightThatIsNowhereANumberIsOutside) {
    const ColorImage strip = tellingStrip(300, 40, 0.5f);
    ScalarImage light = ballLight(60);
    for (int x = 0; x < 60; ++x) light(x, 30) = std::nanf("");
    const GBuffer gbuffer = gbufferFromGuide(light);
    const ObjectTexture worn = synthesizeImageBased(gbuffer, {&strip}, small(8, 4, GetParam())).objects.at(0);
    for (int y = 0; y < worn.pixels.height(); ++y)
        for (int x = 0; x < worn.pixels.width(); ++x) {
            const bool inside = gbuffer.objectId(x + worn.origin.x, y + worn.origin.y) == 1;
            ASSERT_EQ(worn.pixels(x, y).b, inside ? 0.5f : 0.0f) << x << ' ' << y;
        }
}

// Seams of a draft against those of the exact search, over several seeds.
double draftError(const ColorImage& texture, int block) {
    const GBuffer gbuffer = gbufferFromGuide(ballLight(200));
    const synthesis::SearchTexture prepared(texture);
    double exact = 0, draft = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        ImageBasedParams params = small(block);
        params.quilt.seed = seed;
        exact += synthesizeImageBased(gbuffer, {{&texture, &prepared}}, params).report.overlapError;
        params.draft = true;
        draft += synthesizeImageBased(gbuffer, {{&texture, &prepared}}, params).report.overlapError;
    }
    return draft / exact;
}

TEST(ImageBased, ADraftsSeamsAreAlmostAsGood) {
    EXPECT_LT(draftError(test::waves(400, 120, 3), 24), 1.15);
}

TEST(ImageBased, ADraftsSeamsAreAlmostAsGoodOnRealStrips) {
    CHIARO_NEEDS_SHARED_DATA();
    for (const char* name : {"oil_flying_dutchman.png", "wc_blue_19.png", "graphite_edge_gray.png"}) {
        const ColorImage strip = sample::readStrip(test::sharedData() / "samples" / name);
        EXPECT_LT(draftError(gradient::separate(strip).texture, 32), 1.15) << name;
    }
}

TEST(ImageBased, ASampleThatWasPreparedGivesTheSameBytes) {
    const ColorImage strip = noise(100, 40);
    const synthesis::SearchTexture prepared(strip);
    const GBuffer gbuffer = gbufferFromGuide(ballLight(60));
    EXPECT_EQ(synthesizeImageBased(gbuffer, {{&strip, &prepared}}, small()).objects.at(0).pixels,
              synthesizeImageBased(gbuffer, {&strip}, small()).objects.at(0).pixels);
}

TEST_P(BothSearches, OneThreadAndEightGiveTheSameBytes) {
    const ColorImage strip = noise(200, 60);
    const GBuffer gbuffer = gbufferFromGuide(ballLight(150));
    const auto onThreads = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return synthesizeImageBased(gbuffer, {&strip}, small(16, 4, GetParam())).objects.at(0).pixels;
    };
    const ColorImage alone = onThreads(1);
    EXPECT_EQ(alone, onThreads(8));
    ImageBasedParams otherSeed = small(16, 4, GetParam());
    otherSeed.quilt.seed = 2;
    EXPECT_NE(alone, synthesizeImageBased(gbuffer, {&strip}, otherSeed).objects.at(0).pixels);
}

/// Two objects side by side, the second one from x = 22 on, with an edge pixel between that shows both.
GBuffer twoObjects() {
    IdImage ids(60, 40, 1);
    for (int y = 0; y < 40; ++y)
        for (int x = 22; x < 60; ++x) ids(x, y) = 2;
    GBuffer gbuffer = gbufferFromGuide(ScalarImage(60, 40, 0.5f), &ids);
    gbuffer.edgePixels = {21, 7 * 60 + 22};
    for (std::size_t i = 0; i < 2 * GBuffer::samplesPerEdge; ++i)
        gbuffer.edgeSamples.push_back({std::uint16_t(1 + i % 2), 0.5f});
    return gbuffer;
}

TEST(ImageBased, AnObjectsTextureComesFromItsOwnSampleAlone) {
    const ColorImage first = tellingStrip(100, 40, 0.25f), second = tellingStrip(120, 50, -0.5f);
    const ImageBasedTexture texture = synthesizeImageBased(twoObjects(), {&first, &second}, small());
    const gradient::Gradient grey{glm::vec3(0.5f)};
    const GBuffer gbuffer = twoObjects();
    const Frame frame = shadeImageBased(gbuffer, {&grey, &grey}, texture);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x)
            EXPECT_EQ(frame.texture(x, y).b, gbuffer.objectId(x, y) == 1 ? 0.25f : -0.5f) << x << " " << y;
    // The edge pixels are half the one and half the other.
    EXPECT_FLOAT_EQ(frame.picture(21, 0).b, (0.75f + 0.0f) / 2);
    EXPECT_FLOAT_EQ(frame.picture(22, 7).b, (0.75f + 0.0f) / 2);
    EXPECT_EQ(texture.objects[0].pixels.width(), 23);
    EXPECT_EQ(texture.objects[1].origin, glm::ivec2(21, 0));
}

TEST(ImageBased, AnotherObjectChangesNothingForTheFirst) {
    const ColorImage strip = noise(100, 40);
    IdImage ids(60, 40, 1);
    const auto firstWith = [&] {
        const GBuffer gbuffer = gbufferFromGuide(ScalarImage(60, 40, 0.5f), &ids);
        return synthesizeImageBased(gbuffer, {&strip, &strip}, small()).objects.at(0).pixels;
    };
    for (int y = 0; y < 40; ++y) std::ranges::fill(ids.row(y).subspan(22), std::uint16_t(0));
    const ColorImage alone = firstWith();
    for (int y = 0; y < 40; ++y) std::ranges::fill(ids.row(y).subspan(22), std::uint16_t(2));
    EXPECT_EQ(firstWith(), alone);
}

TEST(ImageBased, RecoloursWithoutAnotherSynthesis) {
    const ColorImage strip = noise(100, 40);
    const GBuffer gbuffer = gbufferFromGuide(ballLight(60));
    const ImageBasedTexture texture = synthesizeImageBased(gbuffer, {&strip}, small());
    const gradient::Gradient grey{glm::vec3(0.5f)}, warm{{0.2f, 0.1f, 0.1f}, {1, 0.8f, 0.6f}};
    const Frame before = shadeImageBased(gbuffer, {&grey}, texture);
    const Frame after = shadeImageBased(gbuffer, {&warm}, texture);
    EXPECT_EQ(before.texture, after.texture);
    EXPECT_NE(before.picture, after.picture);
    const glm::vec3 expected = gradient::lookUp(warm, double(gbuffer.light(30, 30))) + after.texture(30, 30);
    EXPECT_EQ(glm::vec3(after.picture(30, 30)), glm::clamp(expected, 0.0f, 1.0f));
}

TEST(ImageBased, RefusesWhatItCannotPaint) {
    const ColorImage strip = noise(100, 40), empty;
    const GBuffer gbuffer = twoObjects();
    EXPECT_THROW(synthesizeImageBased(gbuffer, {&strip}, small()), Error);
    EXPECT_THROW(synthesizeImageBased(gbuffer, {&strip, &empty}, small()), Error);
    EXPECT_THROW(synthesizeImageBased(gbuffer, {&strip, &strip}, small(8, 65)), Error);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(synthesizeImageBased(gbuffer, {&strip, &strip}, small(), Task(stop.get_token())), Cancelled);
}

}  // namespace
}  // namespace chiaro::methods
