#include "core/views/visibility.h"

#include "tests/core/views/meshes.h"

#include <gtest/gtest.h>

namespace chiaro::views {
namespace {

using Faces = std::vector<std::uint32_t>;

/// What the view from +Z sees of these meshes, two faces a square, all of them drawn.
Faces seenFromFront(const std::vector<scene::Mesh>& meshes, const VisibilityQuery& query = {},
                    Projection projection = Projection::Orthographic) {
    const Surface surface = test::surfaceOf(meshes);
    const Occluders drawn(surface, FaceMask(surface.faceCount(), 1), Occluders::Sides::Both, 0);
    View view;
    view.projection = projection;
    return visibleFaces(drawn, framed(view, surface), query);
}

TEST(Visibility, WhatLiesBehindIsHiddenByAnyPixel) {
    EXPECT_EQ(seenFromFront({test::square(0), test::square(1)}), (Faces{2, 3}));
    // A square of a hundredth of the side over the middle hides both halves, though no corner of them.
    EXPECT_EQ(seenFromFront({test::square(0), test::square(1, 0.01f)}), (Faces{2, 3}));
    EXPECT_EQ(seenFromFront({test::square(0), test::square(1, 0.01f)}, {}, Projection::Perspective),
              (Faces{2, 3}));
    // Over one half alone.
    EXPECT_EQ(seenFromFront({test::square(0), test::square(1, 0.01f, {0.5f, -0.5f})}), (Faces{1, 2, 3}));
}

TEST(Visibility, BackSidesHideAndAreNotSeen) {
    scene::Mesh back = test::square(1, 0.01f, {0.5f, -0.5f});
    for (scene::Triangle& triangle : back.triangles) std::swap(triangle[1], triangle[2]);
    EXPECT_EQ(seenFromFront({test::square(0), back}), (Faces{1}));
}

TEST(Visibility, CoincidentFacesDoNotHideEachOther) {
    EXPECT_EQ(seenFromFront({test::square(0), test::square(0)}), (Faces{0, 1, 2, 3}));
    EXPECT_EQ(seenFromFront({test::square(0), test::square(0, 0.3f, {0.1f, 0.2f})}), (Faces{0, 1, 2, 3}));
    for (const float scale : {1e-6f, 1e6f})
        EXPECT_EQ(seenFromFront({test::scaled(test::square(0), scale),
                                 test::scaled(test::square(0, 0.3f, {0.1f, 0.2f}), scale),
                                 test::scaled(test::square(1, 0.1f), scale)}),
                  (Faces{4, 5}));
}

TEST(Visibility, AdjacentFacesAreExceptedButNotWhatIsBehindThem) {
    // A flap hinged on a corner of the square folds over it.
    const scene::Mesh flap = test::triangle({-1, -1, 0}, {1, -0.5f, 0.5f}, {0.5f, 1, 0.5f});
    EXPECT_EQ(seenFromFront({test::square(0), flap}), (Faces{0, 1, 2}));
    // Between them, under the flap, lies a face that touches neither.
    const scene::Mesh between = test::square(0.1f, 0.05f, {0.3f, 0});
    EXPECT_EQ(seenFromFront({test::square(0), flap, between}), (Faces{1, 2}));
}

TEST(Visibility, FacesSmallerThanATexelAreLookedAtByRays) {
    const scene::Mesh speck = test::square(0.5f, 1e-4f, {0.501f, -0.303f});
    EXPECT_EQ(seenFromFront({test::square(0), speck}), (Faces{0, 1, 2, 3}));  // hides no texel centre
    EXPECT_EQ(seenFromFront({test::square(0), speck, test::square(1, 0.1f, {0.5f, -0.3f})}),
              (Faces{1, 4, 5}));
}

TEST(Visibility, AsksForWantedFacesThatFaceTheViewEnough) {
    const FaceMask wanted{0, 1, 1, 0};
    EXPECT_EQ(seenFromFront({test::square(0), test::square(0)}, {0.05, &wanted}), (Faces{1, 2}));
    const scene::Mesh steep = test::triangle({0, 0, 0}, {1, 0, 0}, {0, 0.1f, 1});  // n.v = 0.0995
    EXPECT_EQ(seenFromFront({steep}, {0.09, nullptr}), (Faces{0}));
    EXPECT_EQ(seenFromFront({steep}, {0.11, nullptr}), (Faces{}));
}

TEST(Visibility, FrontsAloneLetViewsLookIntoARoom) {
    scene::Mesh inwards = test::ball(24, 12);
    for (scene::Triangle& triangle : inwards.triangles) std::swap(triangle[1], triangle[2]);
    const Surface room = test::surfaceOf({inwards});
    const View view = framed(View{}, room);
    const FaceMask all(room.faceCount(), 1);
    const auto seen = [&](Occluders::Sides sides) {
        return visibleFaces(Occluders(room, all, sides, 0.05), view, {}).size();
    };
    // From outside nothing but the rim, whose hiders are its neighbours.
    EXPECT_LT(seen(Occluders::Sides::Both), room.faceCount() / 10);
    std::size_t fronts = 0;
    for (std::uint32_t face = 0; face < room.faceCount(); ++face)
        fronts += Projector(view).facing(room, face) > 0.05;
    EXPECT_EQ(seen(Occluders::Sides::Fronts), fronts);
}

}  // namespace
}  // namespace chiaro::views
