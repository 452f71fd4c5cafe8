#include "core/views/view.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace chiaro::views {

namespace {

/// Perpendicular enough to tell which way is up.
bool isUsable(const glm::dvec3& right) {
    return glm::length(right) > 1e-4;
}

/// Reach of the object along the axes of a view, from the surface's centre.
struct Reach {
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{-std::numeric_limits<double>::max()};

    void add(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

template <class Visit>
void forEachCorner(const Surface& surface, const glm::dmat3& basis, Visit visit) {
    const glm::dmat3 toView = glm::transpose(basis);
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face)
        for (std::size_t k = 0; k < 3 && surface.area(face) > 0; ++k)
            visit(toView * (surface.corner(face, k) - surface.center()));
}

constexpr double margin = 0.02;  // of the map's side, on each

void frameOrthographic(View& view, const Surface& surface) {
    const glm::dmat3 basis = view.basis();
    Reach reach;
    forEachCorner(surface, basis, [&](const glm::dvec3& point) { reach.add(point); });
    const glm::dvec3 middle = reach.low * 0.5 + reach.high * 0.5;
    const glm::dvec3 half = reach.high * 0.5 - reach.low * 0.5;
    view.target = surface.center() + basis * middle;
    // A needle seen from its tip is not blown up without bounds.
    view.halfExtent = std::max({half.x, half.y, 0.01 * surface.radius()}) / (1 - 2 * margin);
    view.eyeDistance = 2 * surface.radius();
    view.nearDepth = view.eyeDistance - half.z - 0.1 * surface.radius();
    view.farDepth = view.eyeDistance + half.z + 0.1 * surface.radius();
}

// A point (x, y, z) lies within the cone of sight of an eye (ex, ey, ez) when |x - ex| <= t (ez - z): the eye
// lies between max(x + t z) - t ez and min(x - t z) + t ez, and likewise in y. The nearest such eye has ez =
// (max(x + t z) - min(x - t z)) / 2t.
void framePerspective(View& view, const Surface& surface) {
    const glm::dmat3 basis = view.basis();
    const double tangent = std::tan(glm::radians(view.fieldOfView) / 2);
    const double t = tangent * (1 - 2 * margin);
    Reach plus;
    Reach minus;
    Reach reach;
    forEachCorner(surface, basis, [&](const glm::dvec3& point) {
        plus.add(point + t * point.z);
        minus.add(point - t * point.z);
        reach.add(point);
    });
    const glm::dvec2 needed = (glm::dvec2(plus.high) - glm::dvec2(minus.low)) / (2 * t);
    // Never right on the object, however sharp the point that it turns to the eye.
    const double eye = std::max({needed.x, needed.y, reach.high.z + 0.2 * surface.radius()});
    const glm::dvec2 middle = (glm::dvec2(plus.high) + glm::dvec2(minus.low)) / 2.0;
    const double depth = (reach.low.z + reach.high.z) / 2;
    view.target = surface.center() + basis * glm::dvec3(middle, depth);
    view.eyeDistance = eye - depth;
    view.halfExtent = tangent * view.eyeDistance;
    view.nearDepth = (eye - reach.high.z) * 0.9;
    view.farDepth = (eye - reach.low.z) * 1.1;
}

}  // namespace

glm::dmat3 View::basis() const {
    const glm::dvec3 back = glm::normalize(direction);
    glm::dvec3 right(0);
    for (const glm::dvec3& upwards : {glm::normalize(up), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0)})
        if (!isUsable(right)) right = glm::cross(upwards, back);
    right = glm::normalize(right);
    return {right, glm::cross(back, right), back};
}

glm::dvec3 View::eye() const {
    return target + glm::normalize(direction) * eyeDistance;
}

glm::dmat4 View::viewMatrix() const {
    const glm::dmat4 turn(glm::transpose(basis()));
    return turn * glm::translate(glm::dmat4(1), -eye());
}

glm::dmat4 View::projectionMatrix() const {
    if (projection == Projection::Orthographic)
        return glm::ortho(-halfExtent, halfExtent, -halfExtent, halfExtent, nearDepth, farDepth);
    return glm::perspective(glm::radians(fieldOfView), 1.0, nearDepth, farDepth);
}

View framed(View view, const Surface& surface) {
    if (!(surface.radius() > 0)) return view;
    if (view.projection == Projection::Orthographic)
        frameOrthographic(view, surface);
    else
        framePerspective(view, surface);
    return view;
}

View viewFromCamera(const scene::Camera& camera, const glm::mat4& objectToWorld) {
    const glm::dmat3 toObject = glm::inverse(glm::dmat3(glm::dmat4(objectToWorld)));
    const glm::dmat3 basis(camera.basis());
    View view;
    view.direction = glm::normalize(toObject * basis[2]);
    view.up = glm::normalize(toObject * basis[1]);
    view.locked = true;
    return view;
}

Projector::Projector(const View& view)
    : m_basis(view.basis()),
      m_eye(view.eye()),
      m_scale(view.texelsPerUnit()),
      m_size(view.size),
      m_perspective(view.projection == Projection::Perspective) {
    if (m_perspective) m_scale = m_size / (2 * std::tan(glm::radians(view.fieldOfView) / 2));
}

glm::dvec3 Projector::project(const glm::dvec3& point) const {
    const glm::dvec3 seen = (point - m_eye) * m_basis;  // the transpose times the vector
    const double scale = m_perspective ? m_scale / -seen.z : m_scale;
    return {m_size / 2 + seen.x * scale, m_size / 2 - seen.y * scale, -seen.z};
}

glm::dvec3 Projector::towardsEye(const glm::dvec3& point) const {
    return m_perspective ? glm::normalize(m_eye - point) : m_basis[2];
}

double Projector::facing(const Surface& surface, std::uint32_t face) const {
    if (!(surface.area(face) > 0)) return -1;
    const glm::dvec3& normal = surface.normal(face);
    if (!m_perspective) return glm::dot(normal, m_basis[2]);
    return std::min({facing(surface.corner(face, 0), normal), facing(surface.corner(face, 1), normal),
                     facing(surface.corner(face, 2), normal)});
}

}  // namespace chiaro::views
