#include "core/views/view.h"

#include "tests/core/views/meshes.h"

#include <gtest/gtest.h>

namespace chiaro::views {
namespace {

const std::vector<glm::dvec3> directions{{0, 0, 1}, {0, 1, 0}, {0, -2, 0}, {1, 2, 3}, {-3, 0.1, 0.4}};

View viewFrom(const glm::dvec3& direction, Projection projection) {
    View view;
    view.direction = direction;
    view.projection = projection;
    return view;
}

/// The box that a mesh fills in a view's map, texels.
std::pair<glm::dvec2, glm::dvec2> filled(const Surface& surface, const View& view) {
    const Projector projector(view);
    glm::dvec2 low(1e9);
    glm::dvec2 high(-1e9);
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face)
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 at(projector.project(surface.corner(face, k)));
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
    return {low, high};
}

TEST(View, FrontLooksAlongMinusZWithXRightAndYDown) {
    const Surface surface = test::surfaceOf({test::square(0)});
    const Projector projector(framed(View{}, surface));
    const glm::dvec3 center = projector.project({0, 0, 0});
    EXPECT_NEAR(center.x, 256, 1e-9);
    EXPECT_NEAR(center.y, 256, 1e-9);
    const glm::dvec3 corner = projector.project({1, 1, 0});
    EXPECT_NEAR(corner.x, 512 * 0.98, 1e-9);  // a margin of 2 % on each side
    EXPECT_NEAR(corner.y, 512 * 0.02, 1e-9);
    EXPECT_LT(projector.project({0, 0, 0.5}).z, center.z);
    EXPECT_DOUBLE_EQ(projector.facing({0, 0, 0}, {0, 0, 1}), 1);
    EXPECT_DOUBLE_EQ(projector.facing(surface, 0), 1);
    EXPECT_DOUBLE_EQ(projector.alpha({0, 0, 0}, {1, 0, 0}, 0.05), 0.05);
}

TEST(View, ShowsTheObjectCentredAndAsLargeAsPossible) {
    for (const float scale : {1e-6f, 1.0f, 1e6f})
        for (const Projection projection : {Projection::Orthographic, Projection::Perspective})
            for (const glm::dvec3& direction : directions) {
                const Surface surface =
                    test::surfaceOf({test::scaled(test::box({3, 1, -2}, {1, 0.3f, 0.5f}), scale)});
                const View view = framed(viewFrom(direction, projection), surface);
                const auto [low, high] = filled(surface, view);
                const glm::dvec2 middle = (low + high) / 2.0;
                EXPECT_NEAR(std::max(high.x - low.x, high.y - low.y), 512 * 0.96, 1e-3);
                // In perspective the shorter side is centred for the eye, its picture but nearly.
                const double off = projection == Projection::Orthographic ? 1e-3 : 20;
                EXPECT_NEAR(middle.x, 256, off);
                EXPECT_NEAR(middle.y, 256, off);
            }
}

TEST(View, MatricesSayWhatTheProjectorDoes) {
    const Surface surface = test::surfaceOf({test::box({3, 1, -2}, {1, 0.3f, 0.5f})});
    for (const Projection projection : {Projection::Orthographic, Projection::Perspective})
        for (const glm::dvec3& direction : directions) {
            const View view = framed(viewFrom(direction, projection), surface);
            const Projector projector(view);
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec4 point(surface.corner(5, k), 1);
                const glm::dvec4 clip = view.projectionMatrix() * view.viewMatrix() * point;
                const glm::dvec3 map = projector.project(glm::dvec3(point));
                EXPECT_NEAR((clip.x / clip.w + 1) * 256, map.x, 1e-9);
                EXPECT_NEAR((1 - clip.y / clip.w) * 256, map.y, 1e-9);
                EXPECT_LT(std::abs(clip.z / clip.w), 1);  // nothing is clipped
                EXPECT_NEAR(-(view.viewMatrix() * point).z, map.z, 1e-9);
            }
            const glm::dmat3 basis = view.basis();
            EXPECT_NEAR(glm::determinant(basis), 1, 1e-12);
            EXPECT_GE(basis[1].y, -1e-12);  // what is up stays up
        }
}

TEST(View, FromACameraLooksAtTheObjectWhereItStands) {
    scene::Camera camera;
    camera.azimuth = 90;  // from +X
    camera.elevation = 0;
    glm::mat4 lying(0);  // the object's y is the world's x, its z the world's y, its x the world's z
    lying[0] = {0, 0, 5, 0};
    lying[1] = {5, 0, 0, 0};
    lying[2] = {0, 5, 0, 0};
    lying[3] = {7, 8, 9, 1};
    const View view = viewFromCamera(camera, lying);
    EXPECT_LT(glm::distance(view.direction, glm::dvec3(0, 1, 0)), 1e-6);
    EXPECT_LT(glm::distance(view.up, glm::dvec3(0, 0, 1)), 1e-6);
    EXPECT_TRUE(view.locked);
}

TEST(View, ASharpPointNeverReachesTheEye) {
    const Surface spike = test::surfaceOf({test::triangle({0, 0, 100}, {1, 0, 0}, {0, 1, 0})});
    View view = viewFrom({0, 0, 1}, Projection::Perspective);
    view.fieldOfView = 90;
    view = framed(view, spike);
    EXPECT_GT(view.nearDepth, 0);
    EXPECT_GT(Projector(view).project({0, 0, 100}).z, view.nearDepth);
}

}  // namespace
}  // namespace chiaro::views
