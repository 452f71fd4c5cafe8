#include "core/methods/view_aligned.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace chiaro::methods {
namespace {

using synthesis::LevelStack;

/// Levels of one colour each: 0, 0.1, 0.2, ... in red.
LevelStack flatStack(int count, int size) {
    LevelStack stack;
    for (int i = 0; i < count; ++i) stack.levels.emplace_back(size, size, glm::vec3(0.1f * float(i), 0, 0));
    return stack;
}

/// One level whose red is the texel's x and whose green its y.
LevelStack coordinateStack(int size) {
    LevelStack stack;
    ColorImage& level = stack.levels.emplace_back(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) level(x, y) = {float(x), float(y), 0};
    return stack;
}

float redAt(const LevelStack& stack, float light) {
    return viewAlignedTexture({&stack, nullptr, {}}, {}, {3.5f, 3.5f}, light).r;
}

TEST(ViewAlignedTexture, LevelIIsCentredAtItsSectionAndTheEndsAreClamped) {
    const LevelStack stack = flatStack(8, 16);
    EXPECT_FLOAT_EQ(redAt(stack, 0.5f / 8), 0);
    EXPECT_FLOAT_EQ(redAt(stack, 2.5f / 8), 0.2f);
    EXPECT_FLOAT_EQ(redAt(stack, 3.0f / 8), 0.25f);
    EXPECT_FLOAT_EQ(redAt(stack, 0), 0);
    EXPECT_FLOAT_EQ(redAt(stack, 1), 0.7f);
}

TEST(ViewAlignedTexture, PixelCentresMeetTexelCentresAndTheTextureRepeats) {
    const LevelStack stack = coordinateStack(16);
    const auto at = [&](glm::vec2 position) {
        return glm::vec2(viewAlignedTexture({&stack, nullptr, {}}, {}, position, 0.5f));
    };
    EXPECT_EQ(at({3.5f, 7.5f}), glm::vec2(3, 7));
    EXPECT_EQ(at({19.5f, 23.5f}), glm::vec2(3, 7));
    EXPECT_EQ(at({-12.5f, -8.5f}), glm::vec2(3, 7));
    EXPECT_EQ(at({4.0f, 7.5f}), glm::vec2(3.5f, 7));
    EXPECT_EQ(at({16.0f, 7.5f}), glm::vec2(7.5f, 7));  // halfway between texels 15 and 0
}

TEST(ViewAlignedTexture, OffsetMovesAndDensityScales) {
    const LevelStack stack = coordinateStack(64);
    const ViewAlignedPaint paint{&stack, nullptr, {{10, -4}, 1}};
    EXPECT_EQ(glm::vec2(viewAlignedTexture(paint, {}, {20.5f, 1.5f}, 0.5f)), glm::vec2(10, 5));
    const ViewAlignedPaint still{&stack, nullptr, {}};
    const glm::vec3 half = viewAlignedTexture(still, {.density = 0.5}, {21, 41}, 0.5f);
    EXPECT_EQ(glm::vec2(half), glm::vec2(10, 20));
    const glm::vec3 twice =
        viewAlignedTexture(still, {.density = 2}, {5, 10}, 0.5f);  // the mean of texels 9 and 10
    EXPECT_EQ(glm::vec2(twice), glm::vec2(9.5f, 19.5f));
}

TEST(ZoomOctaves, AnOctaveEndsAsTheNextBegins) {
    const ZoomOctaves rest = zoomOctaves(1);
    EXPECT_FLOAT_EQ(rest.scale, 1);
    EXPECT_FLOAT_EQ(rest.weight, 1);
    EXPECT_FLOAT_EQ(rest.nextWeight, 0);
    const ZoomOctaves end = zoomOctaves(std::nextafter(2.0f, 0.0f));
    EXPECT_NEAR(end.nextScale, 1, 1e-5);
    EXPECT_NEAR(end.nextWeight, 1, 1e-5);
    EXPECT_NEAR(end.weight, 0, 1e-5);
    EXPECT_FLOAT_EQ(zoomOctaves(2).scale, 1);
    EXPECT_FLOAT_EQ(zoomOctaves(0.25f).weight, 1);
}

TEST(ZoomOctaves, FadeInTheMiddleThirdAlone) {
    EXPECT_FLOAT_EQ(zoomOctaves(std::exp2(0.3f)).weight, 1);
    EXPECT_FLOAT_EQ(zoomOctaves(std::exp2(0.7f)).nextWeight, 1);
    const ZoomOctaves middle = zoomOctaves(std::exp2(0.5f));
    EXPECT_NEAR(middle.weight, std::sqrt(0.5), 1e-5);
    EXPECT_NEAR(middle.nextWeight, std::sqrt(0.5), 1e-5);
    ZoomOctaves before = zoomOctaves(1);
    for (float octave = 0.005f; octave < 1; octave += 0.005f) {
        const ZoomOctaves now = zoomOctaves(std::exp2(octave));
        EXPECT_LE(now.weight, before.weight + 1e-5f);
        EXPECT_LT(now.nextWeight - before.nextWeight, 0.05f) << octave;
        before = now;
    }
}

TEST(ZoomOctaves, KeepsContrast) {
    for (float zoom = 0.3f; zoom < 5; zoom *= 1.13f) {
        const ZoomOctaves octaves = zoomOctaves(zoom);
        EXPECT_NEAR(octaves.weight * octaves.weight + octaves.nextWeight * octaves.nextWeight, 1, 1e-5);
        EXPECT_NEAR(octaves.nextScale, 2 * octaves.scale, 1e-5);
    }
}

/// A square grid in the plane z = 0 that looks along +z.
scene::Mesh facingGrid(int side) {
    scene::Mesh mesh;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            mesh.positions.emplace_back(float(x) / float(side - 1) - 0.5f, float(y) / float(side - 1) - 0.5f,
                                        0);
            mesh.normals.emplace_back(0, 0, 1);
        }
    return mesh;
}

ObjectView viewFrom(glm::vec3 eye, glm::vec3 target) {
    return {glm::lookAt(eye, target, {0, 1, 0}), glm::perspective(glm::radians(40.0f), 1.0f, 0.1f, 100.0f),
            400, 400};
}

TEST(Follow, APanMovesTheOffsetAsFarAsTheObjectMovesOnTheScreen) {
    const scene::Mesh grid = facingGrid(21);
    const ObjectView before = viewFrom({0, 0, 5}, {0, 0, 0});
    const ObjectView after = viewFrom({0.1f, 0.2f, 5}, {0.1f, 0.2f, 0});
    const float pixelsPerUnit = before.projection[1][1] * 200 / 5;
    const TexturePlacement placed = follow({{7, 9}, 1}, grid, before, after, {});
    EXPECT_NEAR(placed.offset.x, 7 - 0.1f * pixelsPerUnit, 1e-3);
    EXPECT_NEAR(placed.offset.y, 9 + 0.2f * pixelsPerUnit, 1e-3);
    EXPECT_NEAR(placed.zoom, 1, 1e-4);
}

TEST(Follow, NothingMovesNothingChanges) {
    const ObjectView view = viewFrom({1, 2, 5}, {0, 0, 0});
    const TexturePlacement placed = follow({{3, 4}, 1.5f}, facingGrid(9), view, view, {});
    EXPECT_NEAR(placed.offset.x, 3, 1e-4);
    EXPECT_NEAR(placed.offset.y, 4, 1e-4);
    EXPECT_NEAR(placed.zoom, 1.5f, 1e-5);
}

TEST(Follow, ZoomKeepsTheTextureOnTheSurface) {
    const scene::Mesh grid = facingGrid(21);
    const ObjectView before = viewFrom({0.3f, 0, 5}, {0.3f, 0, 0});
    const ObjectView after = viewFrom({0.3f, 0, 4}, {0.3f, 0, 0});
    const TexturePlacement placed = follow({}, grid, before, after, {});
    EXPECT_NEAR(placed.zoom, 1.25f, 1e-3);
    // The surface point at the origin must keep its place in the texture.
    const auto texelOf = [](const ObjectView& view, const TexturePlacement& placement) {
        const glm::vec4 clip = view.projection * view.objectToView * glm::vec4(0, 0, 0, 1);
        const glm::vec2 screen = (glm::vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * 400.0f;
        return (screen - placement.offset) * zoomOctaves(placement.zoom).scale;
    };
    const glm::vec2 earlier = texelOf(before, {});
    const glm::vec2 later = texelOf(after, placed);
    EXPECT_NEAR(earlier.x, later.x, 0.05);
    EXPECT_NEAR(earlier.y, later.y, 0.05);
}

TEST(Follow, AnObjectOutOfViewKeepsItsPlacement) {
    const ObjectView away = viewFrom({0, 0, 5}, {0, 0, 10});
    const TexturePlacement placement{{3, 4}, 1.5f};
    EXPECT_EQ(follow(placement, facingGrid(5), away, away, {}), placement);
}

}  // namespace
}  // namespace chiaro::methods
