#include "core/base/error.h"
#include "core/metrics/coherence.h"
#include "core/metrics/heat_map.h"
#include "core/metrics/similarity.h"
#include "tests/core/metrics/pictures.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <limits>
#include <set>

namespace chiaro::metrics {
namespace {

MeasuredFrame frameOf(const ColorImage& picture, const IdImage* objects = nullptr,
                      const ScalarImage* light = nullptr) {
    MeasuredFrame frame;
    frame.picture = &picture;
    frame.objects = objects;
    frame.light = light;
    return frame;
}

MeasureParams drawing(int pixels, int block = 8, int neighbours = 3) {
    MeasureParams params;
    params.pixels = pixels;
    params.block = block;
    params.neighbours = neighbours;
    return params;
}

TEST(Measure, BlocksLieInsideThePictureAndOnOneObject) {
    const ColorImage picture = test::speckled(12, 6, 1);
    IdImage objects(12, 6, 1);
    for (int y = 0; y < 6; ++y)
        for (int x = 6; x < 12; ++x) objects(x, y) = 2;
    objects(11, 5) = 0;
    const auto where = [&](const MeasuredFrame& frame) {
        std::set<std::pair<int, int>> pixels;
        for (const glm::ivec2 pixel : drawPixels(measurable(frame, 4), 0, 1, "mask"))
            pixels.insert({pixel.x, pixel.y});
        return pixels;
    };
    std::set<std::pair<int, int>> expected;
    for (int y = 2; y <= 4; ++y)
        for (const int x : {2, 3, 4, 8, 9, 10})
            if (x < 10 || y < 4) expected.insert({x, y});
    EXPECT_EQ(where(frameOf(picture, &objects)), expected);
    MeasuredFrame second = frameOf(picture, &objects);
    second.object = 2;
    std::erase_if(expected, [](const auto& pixel) { return pixel.first < 6; });
    EXPECT_EQ(where(second), expected);
    EXPECT_EQ(where(frameOf(picture)).size(), 9u * 3u);
}

TEST(Measure, DrawsEachPixelOnceAndBySeed) {
    const Image<std::uint8_t> all(10, 10, 1);
    const auto drawn = drawPixels(all, 60, 7, "mask");
    std::set<std::pair<int, int>> distinct;
    for (const glm::ivec2 pixel : drawn) distinct.insert({pixel.x, pixel.y});
    EXPECT_EQ(distinct.size(), 60u);
    EXPECT_EQ(drawn, drawPixels(all, 60, 7, "mask"));
    EXPECT_NE(drawn, drawPixels(all, 60, 8, "mask"));
    EXPECT_EQ(drawPixels(all, 500, 7, "mask").size(), 100u);
    EXPECT_THROW(drawPixels(Image<std::uint8_t>(10, 10, 0), 5, 7, "mask"), Error);
}

TEST(Measure, EstimatesTellHowSureTheyAre) {
    const Estimate of = estimate({1, 2, 3, 6});
    EXPECT_DOUBLE_EQ(of.mean, 3);
    EXPECT_DOUBLE_EQ(of.standardError, std::sqrt((4 + 1 + 0 + 9) / 3.0 / 4));
    EXPECT_EQ(of.count, 4u);
    EXPECT_EQ(estimate({5}).standardError, 0);
}

TEST(Measure, TheSourceAgainstItselfIsZero) {
    const ColorImage source = test::speckled(60, 40, 1);
    const NeighbourIndex index(source, 8);
    ScalarImage light(60, 40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) light(x, y) = float(x) / 59;
    const FrameMeasure measure = measureFrame(index, frameOf(source, nullptr, &light), drawing(0, 8, 1));
    EXPECT_EQ(measure.similarity.mean, 0);
    EXPECT_EQ(measure.similarity.count, 53u * 33u);
    EXPECT_NEAR(measure.shadingAbsolute->mean, 0, 1e-7);
    EXPECT_NEAR(measure.shadingSquared->mean, 0, 1e-12);
}

TEST(Measure, ShadingErrorIsOfTheMeanShade) {
    const ColorImage source = test::speckled(60, 40, 1);
    const NeighbourIndex index(source, 8);
    const ColorImage picture = test::speckled(9, 9, 2);
    ScalarImage light(9, 9, 0.25f);
    light(4, 4) = std::numeric_limits<float>::quiet_NaN();  // nothing there
    const auto frame = frameOf(picture, nullptr, &light);
    const FrameMeasure measure = measureFrame(index, frame, drawing(0));
    EXPECT_EQ(measure.similarity.count, 4u);
    ASSERT_EQ(measure.shadingAbsolute->count, 3u);
    double absolute = 0, squared = 0;
    const BinImage bins = binned(picture, index.bins());
    for (const glm::ivec2 pixel : {glm::ivec2(5, 4), glm::ivec2(4, 5), glm::ivec2(5, 5)}) {
        double shade = 0;
        for (const Neighbour& one : index.nearest(describe(bins, {pixel, 8}), 3))
            shade += one.pixel.x / 59.0 / 3;
        absolute += std::abs(shade - 0.25) / 3;
        squared += (shade - 0.25) * (shade - 0.25) / 3;
    }
    EXPECT_NEAR(measure.shadingAbsolute->mean, absolute, 1e-6);
    EXPECT_NEAR(measure.shadingSquared->mean, squared, 1e-6);
    EXPECT_FALSE(measureFrame(index, frameOf(picture), drawing(0)).shadingAbsolute);
}

TEST(Measure, IsTheSameOnAnyNumberOfThreads) {
    const NeighbourIndex index(test::blotched(70, 50, 1), 8);
    const ColorImage picture = test::blotched(50, 40, 2);
    const FrameMaps many = mapFrame(index, frameOf(picture), 3);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const NeighbourIndex again(test::blotched(70, 50, 1), 8);
    const FrameMaps single = mapFrame(again, frameOf(picture), 3);
    EXPECT_EQ(many.similarity, single.similarity);
    EXPECT_EQ(many.best, single.best);
    EXPECT_EQ(many.measure.similarity.mean, single.measure.similarity.mean);
}

TEST(Measure, MapsHoldWhatIsMeasuredAndNothingElsewhere) {
    const NeighbourIndex index(test::speckled(50, 40, 1), 8);
    const ColorImage picture = test::speckled(20, 16, 2);
    const FrameMaps maps = mapFrame(index, frameOf(picture), 3);
    EXPECT_EQ(maps.similarity(3, 8), -1);
    EXPECT_EQ(maps.best(3, 8), glm::i16vec2(-1));
    EXPECT_EQ(maps.shadingError(8, 8), -1);
    const auto nearest = index.nearest(describe(binned(picture, index.bins()), {{8, 8}, 8}), 1).front();
    EXPECT_EQ(maps.similarity(8, 8), float(nearest.distance));
    EXPECT_EQ(glm::ivec2(maps.best(8, 8)), nearest.pixel);
    EXPECT_NEAR(maps.measure.similarity.mean,
                measureFrame(index, frameOf(picture), drawing(0)).similarity.mean, 1e-12);
}

TEST(Measure, RefusesWhatDoesNotFit) {
    const NeighbourIndex index(test::speckled(50, 40, 1), 8);
    const ColorImage picture = test::speckled(20, 16, 2), small = test::speckled(7, 30, 2);
    const IdImage nowhere(20, 16, 0), other(19, 16, 1);
    EXPECT_THROW(measureFrame(index, frameOf(picture, &nowhere), drawing(100)), Error);
    EXPECT_THROW(measureFrame(index, frameOf(picture, &other), drawing(100)), Error);
    EXPECT_THROW(measureFrame(index, frameOf(small), drawing(100)), Error);
    EXPECT_THROW(measureFrame(index, frameOf(picture), drawing(100, 12)), Error);
}

TEST(Coherence, InTheImageComparesTheSamePixel) {
    const ColorImage source = test::speckled(50, 40, 1);
    const Bins bins = binsOf(source);
    const ColorImage first = test::part(source, 0, 0, 30, 30), second = test::part(source, 4, 2, 30, 30);
    EXPECT_EQ(imageCoherence(bins, frameOf(first), frameOf(first), drawing(50)).mean, 0);
    const Estimate moved = imageCoherence(bins, frameOf(first), frameOf(second), drawing(0));
    EXPECT_EQ(moved.count, 23u * 23u);
    EXPECT_GT(moved.mean, 0.05);
    const BinImage a = binned(first, bins), b = binned(second, bins);
    double mean = 0;
    for (int y = 4; y <= 26; ++y)
        for (int x = 4; x <= 26; ++x)
            mean += distance(describe(a, {{x, y}, 8}), describe(b, {{x, y}, 8}), 8) / (23 * 23);
    EXPECT_NEAR(moved.mean, mean, 1e-12);
}

TEST(Coherence, OnTheObjectFollowsItsMotion) {
    const ColorImage source = test::speckled(50, 40, 1);
    const Bins bins = binsOf(source);
    // What stands at (x, y) stands at (x - 4, y - 2) in the next frame.
    const ColorImage first = test::part(source, 0, 0, 30, 30), second = test::part(source, 4, 2, 30, 30);
    // Blocks at the border see other edges, so both objects keep a pixel off it.
    IdImage inner(30, 30, 0);
    for (int y = 1; y < 29; ++y)
        for (int x = 1; x < 29; ++x) inner(x, y) = 1;
    const MeasuredFrame before = frameOf(first, &inner), after = frameOf(second, &inner);
    for (const glm::vec2 displacement :
         {glm::vec2(-4, -2), glm::vec2(-3.6f, -2.4f), glm::vec2(-4.5f, -2.5f)}) {
        const Image<glm::vec2> motion(30, 30, displacement);
        SurfaceMotion surface;
        surface.displacement = &motion;
        const Estimate still = objectCoherence(bins, before, after, surface, drawing(0));
        EXPECT_EQ(still.mean, 0) << displacement.x;
        EXPECT_EQ(still.count, 17u * 19u);
    }
    Image<glm::vec2> motion(30, 30, glm::vec2(-4, -2));
    SurfaceMotion surface;
    surface.displacement = &motion;
    Image<std::uint8_t> seen(30, 30, 0);
    seen(15, 15) = seen(16, 15) = 1;
    surface.seen = &seen;
    EXPECT_EQ(objectCoherence(bins, before, after, surface, drawing(0)).count, 2u);
    motion(15, 15) = glm::vec2(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(objectCoherence(bins, before, after, surface, drawing(0)).count, 1u);
    motion(16, 15) = glm::vec2(1e9f);
    EXPECT_THROW(objectCoherence(bins, before, after, surface, drawing(0)), Error);
    IdImage other = inner;
    for (std::uint16_t& id : other.pixels()) id = std::uint16_t(2 * id);
    surface.seen = nullptr;
    EXPECT_THROW(objectCoherence(bins, before, frameOf(second, &other), surface, drawing(0)), Error);
    EXPECT_THROW(imageCoherence(bins, before, frameOf(second, &other), drawing(0)), Error);
}

TEST(Coherence, WhatStandsBeforeAnotherHidesIt) {
    scene::GBuffer first, second;
    first.width = second.width = first.height = second.height = 5;
    first.objectId = second.objectId = IdImage(5, 5, 1);
    first.depth = second.depth = ScalarImage(5, 5, 2);
    Image<scene::SeenPoint> landings(5, 5);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x) landings(x, y) = {glm::vec2(x, y) + glm::vec2(1.5f, 0.5f), 2, 1};
    second.depth(3, 2) = 1;     // something nearer
    second.objectId(2, 4) = 2;  // another object
    const Image<std::uint8_t> seen = seenInBoth(first, landings, second);
    EXPECT_EQ(seen(0, 0), 1);
    EXPECT_EQ(seen(4, 0), 0);  // leaves the picture
    EXPECT_EQ(seen(2, 2), 0);
    EXPECT_EQ(seen(1, 4), 0);
}

TEST(HeatMap, ColoursGrowBrighterAndNothingIsGrey) {
    ScalarImage values(4, 1);
    values(0, 0) = 0, values(1, 0) = 0.1f, values(2, 0) = 0.2f, values(3, 0) = -1;
    const ColorImage map = heatMap(values, 0, 0.2f);
    const auto luma = [&](int x) { return map(x, 0).r + map(x, 0).g + map(x, 0).b; };
    EXPECT_LT(luma(0), luma(1));
    EXPECT_LT(luma(1), luma(2));
    EXPECT_EQ(map(3, 0).r, map(3, 0).b);
    EXPECT_EQ(heatMapEnd(ScalarImage(300, 1, 0.195f)), 0.2f);
    EXPECT_EQ(heatMapEnd(ScalarImage(3, 3, -1)), 0.01f);
    EXPECT_EQ(heatMapWithBar(ScalarImage(30, 50, 0.1f), 0, 1).height(), 50);
    EXPECT_GT(heatMapWithBar(ScalarImage(3, 2, 0.1f), 0, 1).width(), 3);
}

}  // namespace
}  // namespace chiaro::metrics
