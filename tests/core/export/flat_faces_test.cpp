#include "core/export/flat_faces.h"

#include "core/base/random.h"
#include "tests/core/export/flat_overlap.h"

#include <gtest/gtest.h>

namespace chiaro::exporting {
namespace {

FlatFaces unitSquare(std::size_t count = 16) {
    return FlatFaces({0, 0}, {1, 1}, count);
}

TEST(FlatFaces, MayTouch) {
    FlatFaces faces = unitSquare();
    EXPECT_TRUE(faces.add({{{0, 0}, {1, 0}, {0, 1}}}));
    EXPECT_TRUE(faces.add({{{1, 0}, {1, 1}, {0, 1}}}));    // the other half of the square
    EXPECT_TRUE(faces.add({{{1, 0}, {2, 0}, {1, 0.5}}}));  // a corner on a corner, beyond the grid
}

TEST(FlatFaces, MayNotOverlap) {
    FlatFaces faces = unitSquare();
    EXPECT_TRUE(faces.add({{{0, 0}, {1, 0}, {0, 1}}}));
    EXPECT_FALSE(faces.add({{{0, 0}, {1, 0}, {0, 1}}}));              // the same once more
    EXPECT_FALSE(faces.add({{{0.1, 0.1}, {0.2, 0.1}, {0.1, 0.2}}}));  // inside it
    EXPECT_FALSE(faces.add({{{-1, -1}, {3, -1}, {-1, 3}}}));          // around it
    EXPECT_FALSE(faces.add({{{0.4, 0.4}, {1, 0.4}, {1, 1}}}));        // a corner inside
    EXPECT_TRUE(faces.add({{{0.6, 0.41}, {1, 0.41}, {1, 1}}}));       // refused ones left nothing behind
}

TEST(FlatFaces, KeepFromARandomHeapNoTwoThatOverlap) {
    Random random(7);
    FlatFaces faces = unitSquare(300);
    std::vector<FlatFace> kept;
    for (int i = 0; i < 300; ++i) {
        const glm::dvec2 centre(random.uniform(), random.uniform());
        const double size = 0.02 + 0.2 * random.uniform() * random.uniform();
        FlatFace face;
        for (glm::dvec2& corner : face)
            corner = centre + size * (glm::dvec2(random.uniform(), random.uniform()) - 0.5);
        const glm::dvec2 a = face[1] - face[0], b = face[2] - face[0];
        if (a.x * b.y < a.y * b.x) std::swap(face[1], face[2]);
        double most = 0;
        for (const FlatFace& other : kept) most = std::max(most, test::commonArea(face, other));
        if (most > 0 && most < 1e-9) continue;  // too near to call
        EXPECT_EQ(faces.add(face), most == 0) << i << ": " << most;
        if (most == 0) kept.push_back(face);
    }
    EXPECT_GT(kept.size(), 30u);
    EXPECT_LT(kept.size(), 250u);
}

}  // namespace
}  // namespace chiaro::exporting
