#include "core/methods/view_dependent.h"

#include "core/base/random.h"
#include "core/methods/view_map.h"
#include "tests/core/scene/shapes.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

namespace chiaro::methods {
namespace {

/// Two levels of soft spots of random grey.
std::vector<synthesis::LevelSource> spottedSources() {
    std::vector<synthesis::LevelSource> sources(2);
    Random random(5);
    for (synthesis::LevelSource& source : sources) {
        source.texture = ColorImage(96, 64, glm::vec3(0.01f));  // nowhere 0
        source.quilt.block = 16;
        source.quilt.seed = random.bits() >> 11;
        for (int spot = 0; spot < 500; ++spot) {
            const glm::vec2 centre(random.uniform() * 96, random.uniform() * 64);
            const float strength = 0.3f * (float(random.uniform()) - 0.5f);
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < 96; ++x) {
                    const glm::vec2 from = glm::vec2(x, y) - centre;
                    source.texture(x, y) += glm::vec3(strength * std::exp(-glm::dot(from, from) / 8));
                }
        }
    }
    return sources;
}

std::shared_ptr<const PlannedObject> planned(scene::Mesh mesh, int size = 128, int count = 8) {
    views::ViewParams params;
    params.size = size;
    params.count = count;
    return planObject(std::make_shared<const scene::Mesh>(std::move(mesh)), params);
}

std::shared_ptr<PaintedObject> painted(scene::Mesh mesh, bool propagate = true) {
    auto object = std::make_shared<PaintedObject>();
    object->planned = planned(std::move(mesh));
    object->weights = std::make_shared<const ViewWeights>(*object->planned, 0.05);
    object->textures = synthesizeViews(*object->planned, spottedSources(), propagate);
    return object;
}

glm::vec2 placeOf(const ViewWeights::FaceView& view, glm::vec3 weights) {
    const auto& [a, b, c] = view.corners;
    return a.position * weights.x + b.position * weights.y + c.position * weights.z;
}

/// Correlation of what two views have at the same places of their shared faces, weighted by both alphas.
double overlapCorrelation(const PaintedObject& object) {
    double sum = 0, first = 0, second = 0;
    Random random(11);
    for (std::uint32_t face = 0; face < object.planned->surface.faceCount(); ++face) {
        const auto views = object.weights->of(face);
        for (std::size_t i = 0; i < views.size(); ++i)
            for (std::size_t j = i + 1; j < views.size(); ++j)
                for (int point = 0; point < 4; ++point) {
                    glm::vec3 at(random.uniform(), random.uniform(), random.uniform());
                    at /= at.x + at.y + at.z;
                    const double weight =
                        double(views[i].corners[0].weight) * double(views[j].corners[0].weight);
                    const auto texel = [&](const ViewWeights::FaceView& view) {
                        return double(object.textures.views[view.group].at(1, placeOf(view, at)).x);
                    };
                    const double a = texel(views[i]), b = texel(views[j]);
                    sum += weight * a * b;
                    first += weight * a * a;
                    second += weight * b * b;
                }
    }
    return sum / std::sqrt(first * second);
}

TEST(PlanObject, GivesAllViewsOfAnObjectMapsOfOneDensity) {
    scene::Mesh needle = test::ball(24, 12);
    for (glm::vec3& position : needle.positions) position.x *= 3;
    const auto object = planned(std::move(needle), 256);
    int largest = 0;
    double least = 1e9, most = 0;
    for (const views::FaceGroup& group : object->plan.groups) {
        largest = std::max(largest, group.view.size);
        least = std::min(least, group.view.texelsPerUnit());
        most = std::max(most, group.view.texelsPerUnit());
    }
    EXPECT_EQ(largest, 256);
    EXPECT_LT(most, 1.01 * least);
}

TEST(ViewTextures, ViewsAgreeOnTheFacesTheyShareWhenTheyPropagate) {
    const double with = overlapCorrelation(*painted(test::ball(48, 24)));
    const double without = overlapCorrelation(*painted(test::ball(48, 24), false));
    EXPECT_GT(with, 0.85);
    EXPECT_LT(std::abs(without), 0.15);
    std::printf("correlation in overlaps: %.3f propagated, %.3f not\n", with, without);
}

TEST(ViewTextures, DependOnTheArgumentsAlone) {
    const auto object = planned(test::ball(24, 12), 96, 5);
    const auto made = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return synthesizeViews(*object, spottedSources(), true);
    };
    const ViewTextures one = made(1), eight = made(8);
    ASSERT_EQ(one.views.size(), eight.views.size());
    for (std::size_t i = 0; i < one.views.size(); ++i) EXPECT_EQ(one.views[i].levels, eight.views[i].levels);
    EXPECT_GT(one.report.blocks, 10u);
}

TEST(ViewTextures, CoverEveryTexelOfTheirGroup) {
    const auto object = painted(test::ball(48, 24));
    for (std::size_t group = 0; group < object->textures.views.size(); ++group) {
        const ViewMap map = ViewMap::of(*object->planned, group);
        if (map.face.empty()) continue;
        int bare = 0, covered = 0;
        for (std::size_t i = 0; i < map.covered.pixelCount(); ++i) {
            covered += map.covered.pixels()[i] != 0;
            bare += map.covered.pixels()[i] != 0 &&
                    object->textures.views[group].levels[0].pixels()[i] == PackedTexel(0);
        }
        EXPECT_GT(covered, 500);
        EXPECT_LT(bare, covered / 500);  // strokes pass through 0
    }
}

TEST(ViewTextures, TexelsSurvivePacking) {
    for (const float value : {-1.0f, -0.25f, 0.0f, 0.3f, 1.0f})
        EXPECT_NEAR(unpacked(packed(glm::vec3(value))).x, value, 2e-5f);
    EXPECT_EQ(unpacked(packed(glm::vec3(2, 0, -2))), glm::vec3(1, 0, -1));
}

/// Two levels that are one colour all over, another for each view: what shows is the weights.
PaintedObject paintedFlat(scene::Mesh mesh) {
    PaintedObject object;
    object.planned = planned(std::move(mesh));
    object.weights = std::make_shared<const ViewWeights>(*object.planned, 0.05);
    Random random(2);
    for (std::size_t i = 0; i < object.planned->plan.groups.size(); ++i) {
        const PackedTexel texel = packed(glm::vec3(float(random.uniform()) - 0.5f));
        object.textures.views.push_back(
            {glm::ivec2(0), {Image<PackedTexel>(4, 4, texel), Image<PackedTexel>(4, 4, texel)}});
    }
    return object;
}

TEST(ViewWeights, NoEdgeOfAGroupShows) {
    const PaintedObject object = paintedFlat(test::ball(96, 48));
    const ViewDependentPaint paint{&object, nullptr, {}};
    const auto& triangles = object.planned->surface.mesh().triangles;
    // The middle of each edge as its two faces paint it.
    std::map<std::pair<std::uint32_t, std::uint32_t>, float> seen;
    float largest = 0;
    int edges = 0;
    for (std::uint32_t face = 0; face < triangles.size(); ++face)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[face][k], b = triangles[face][(k + 1) % 3];
            glm::vec3 at(0);
            at[glm::length_t(k)] = at[glm::length_t((k + 1) % 3)] = 0.5f;
            const float value = viewDependentTexture(paint, {}, face, {at.y, at.z}, 0.5f).x;
            const auto [other, isNew] = seen.try_emplace(std::minmax(a, b), value);
            if (isNew) continue;
            largest = std::max(largest, std::abs(other->second - value));
            ++edges;
        }
    EXPECT_GT(edges, 5000);
    EXPECT_LT(largest, 0.02f);
}

TEST(ViewDependent, BlendsByWeightAndKeepsContrastOnRequest) {
    const PaintedObject object = paintedFlat(test::ball(24, 12));
    for (std::uint32_t face = 0; face < object.planned->surface.faceCount(); face += 17) {
        const auto views = object.weights->of(face);
        ASSERT_FALSE(views.empty());
        float sum = 0, total = 0, squares = 0;
        for (const ViewWeights::FaceView& view : views) {
            sum += view.corners[0].weight * unpacked(object.textures.views[view.group].levels[0](0, 0)).x;
            total += view.corners[0].weight;
            squares += view.corners[0].weight * view.corners[0].weight;
        }
        const ViewDependentPaint paint{&object, nullptr, {}};
        EXPECT_NEAR(viewDependentTexture(paint, {}, face, {0, 0}, 0.3f).x, sum / total, 1e-5f);
        ViewDependentParams preserving;
        preserving.blend = Blend::Preserving;
        EXPECT_NEAR(viewDependentTexture(paint, preserving, face, {0, 0}, 0.3f).x, sum / std::sqrt(squares),
                    1e-5f);
    }
}

TEST(ViewDependent, FollowingTheCameraFavoursTheViewsNearIt) {
    PaintedObject object = paintedFlat(test::ball(24, 12));
    for (std::size_t group = 0; group < object.textures.views.size(); ++group)
        object.textures.views[group].levels.assign(
            2, Image<PackedTexel>(4, 4, packed(glm::vec3(group == 0 ? 1.0f : 0.0f))));
    const ViewDependentPaint paint{&object, nullptr,
                                   glm::vec3(object.planned->plan.groups[0].view.direction * 50.0)};
    ViewDependentParams follow;
    follow.followCamera = true;
    int faces = 0;
    for (const std::uint32_t face : object.planned->plan.groups[0].faces) {
        const float still = viewDependentTexture(paint, {}, face, {0.3f, 0.3f}, 0.5f).x;
        if (still < 0.01f || still > 0.99f) continue;
        EXPECT_GT(viewDependentTexture(paint, follow, face, {0.3f, 0.3f}, 0.5f).x, still);
        ++faces;
    }
    EXPECT_GT(faces, 20);
}

/// Too small for any texel's centre, and inside the ball, so that it has a view of its own.
TEST(ViewDependent, PaintsASpeckThatItsViewHasNoTexelFor) {
    scene::Mesh mesh = test::ball(16, 8);
    const auto first = std::uint32_t(mesh.positions.size()), face = std::uint32_t(mesh.triangles.size());
    for (const glm::vec3 corner : {glm::vec3(0), glm::vec3(1e-4f, 0, 0), glm::vec3(0, 1e-4f, 5e-5f)}) {
        mesh.positions.push_back(glm::vec3(0.0123f, 0.0377f, 0.0211f) + corner);
        mesh.normals.push_back(glm::vec3(0, 0, 1));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    const auto object = painted(std::move(mesh));
    ASSERT_FALSE(object->weights->of(face).empty());
    EXPECT_NE(viewDependentTexture({object.get(), nullptr, {}}, {}, face, {0.3f, 0.3f}, 0.5f), glm::vec3(0));
}

TEST(ViewDependent, PaintsEveryPixelOfOddMeshes) {
    scene::Mesh tiny = test::ball(16, 8), huge = test::ball(16, 8), single = test::quad();
    for (glm::vec3& position : tiny.positions) position *= 1e-6f;
    for (glm::vec3& position : huge.positions) position *= 1e6f;
    single.triangles.resize(1);
    for (const scene::Mesh& mesh : {tiny, huge, single, test::quad()}) {
        const auto object = painted(mesh);
        const scene::Scene scene = test::sceneOf({mesh});
        const scene::GBuffer gbuffer = scene::castGBuffer(
            scene::RayScene(scene), scene.lights, test::frontCamera().framed(boundsOf(scene)), 64, 64);
        const gradient::Gradient gradient{glm::vec3(0.5f)};
        const Frame frame = renderViewDependent(gbuffer, {{object.get(), &gradient, {}}}, {});
        int covered = 0, bare = 0;
        for (std::size_t i = 0; i < frame.texture.pixelCount(); ++i) {
            if (gbuffer.objectId.pixels()[i] == 0) continue;
            ++covered;
            bare += frame.texture.pixels()[i] == glm::vec3(0);
        }
        EXPECT_GT(covered, 300);
        EXPECT_LT(bare, covered / 20);
    }
}

}  // namespace
}  // namespace chiaro::methods
