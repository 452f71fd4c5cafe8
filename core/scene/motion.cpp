#include "core/scene/motion.h"

#include <tbb/parallel_for.h>

#include <limits>

namespace chiaro::scene {

namespace {

/// A camera's picture as positions of pixels, in double precision: differences of positions are the point.
class Perspective {
public:
    Perspective(const Camera& camera, int width, int height)
        : m_basis(camera.basis()),
          m_eye(glm::dvec3(camera.target) + m_basis[2] * double(camera.eyeDistance())),
          m_half(camera.halfExtent(width, height)),
          m_size(width, height) {}

    const glm::dvec3& eye() const { return m_eye; }

    glm::dvec3 pointAt(glm::dvec2 position, double depth) const {
        const glm::dvec2 slope = (position / m_size * 2.0 - 1.0) * m_half;
        return m_eye + depth * (m_basis[0] * slope.x - m_basis[1] * slope.y - m_basis[2]);
    }

    SeenPoint seen(const glm::dvec3& point, glm::vec3 normal) const {
        const glm::dvec3 fromEye = point - m_eye;
        const double depth = -glm::dot(fromEye, m_basis[2]);
        if (!(depth > 0)) return {};
        const glm::dvec2 slope =
            glm::dvec2(glm::dot(fromEye, m_basis[0]), -glm::dot(fromEye, m_basis[1])) / depth;
        return {glm::vec2((slope / m_half + 1.0) * 0.5 * m_size), float(depth),
                float(-glm::dot(glm::dvec3(normal), glm::normalize(fromEye)))};
    }

private:
    glm::dmat3 m_basis;
    glm::dvec3 m_eye;
    glm::dvec2 m_half;
    glm::dvec2 m_size;
};

}  // namespace

Image<SeenPoint> seenFrom(const GBuffer& gbuffer, const Camera& camera, const Camera& other) {
    const Perspective here(camera, gbuffer.width, gbuffer.height);
    const Perspective there(other, gbuffer.width, gbuffer.height);
    Image<SeenPoint> points(gbuffer.width, gbuffer.height);
    tbb::parallel_for(0, gbuffer.height, [&](int y) {
        for (int x = 0; x < gbuffer.width; ++x) {
            if (gbuffer.objectId(x, y) == 0) continue;
            const glm::dvec3 point = here.pointAt(glm::dvec2(x, y) + 0.5, double(gbuffer.depth(x, y)));
            points(x, y) = there.seen(point, gbuffer.normal(x, y));
        }
    });
    return points;
}

Image<glm::vec2> screenMotion(const GBuffer& gbuffer, const Camera& camera, const Camera& other) {
    const Image<SeenPoint> points = seenFrom(gbuffer, camera, other);
    Image<glm::vec2> motion(gbuffer.width, gbuffer.height, glm::vec2(0));
    for (int y = 0; y < gbuffer.height; ++y)
        for (int x = 0; x < gbuffer.width; ++x)
            if (points(x, y).exists()) motion(x, y) = points(x, y).position - (glm::vec2(x, y) + 0.5f);
    return motion;
}

}  // namespace chiaro::scene
