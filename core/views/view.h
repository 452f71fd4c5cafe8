#pragma once

#include "core/scene/camera.h"
#include "core/views/surface.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <string>

namespace chiaro::views {

/// How a view flattens the object. Orthographic is the default: the map of a face is then affine, so that
/// texture propagates through shared faces exactly (§4.3), and near and far parts get strokes of one size.
enum class Projection { Orthographic, Perspective };

/// A viewpoint on one object, in its object space, with a square texture map of size x size texels (§4.3). A
/// plain value: the direction and what stands above `target` is the artist's, the framing follows from the
/// object (see framed).
struct View {
    std::string name;               ///< "View 3"
    glm::dvec3 direction{0, 0, 1};  ///< from the object towards the eye, any length but zero
    glm::dvec3 up{0, 1, 0};         ///< upwards in the map; when parallel to the direction, another is taken
    Projection projection = Projection::Orthographic;
    double fieldOfView = 30;  ///< degrees across the map, 1..120; perspective only
    int size = 512;           ///< the map's side, texels
    bool locked = false;      ///< the artist's: planning keeps it as it is

    glm::dvec3 target{0};    ///< what the map's centre shows
    double halfExtent = 1;   ///< half the map's side, in units of the object, at the target's depth
    double eyeDistance = 2;  ///< from the target; the eye of an orthographic view only measures depth
    double nearDepth = 0.9;  ///< clipping depths; the object lies between them
    double farDepth = 3.1;

    friend bool operator==(const View&, const View&) = default;

    /// Columns: right, up, and towards the eye; orthonormal.
    glm::dmat3 basis() const;
    glm::dvec3 eye() const;
    /// Object to view space: x right, y up, the view looks along -z.
    glm::dmat4 viewMatrix() const;
    /// View space to OpenGL clip space (z in [-w, w], y up).
    glm::dmat4 projectionMatrix() const;
    /// Texels a unit of length at the target's depth takes.
    double texelsPerUnit() const { return size / (2 * halfExtent); }
};

/// The view aimed so that the whole object is centred and as large as possible in the map, but for a margin
/// of 2 % on each side. The object stays where it is also when only few of its faces are drawn: a further
/// pass then paints with strokes as large as those of the first. Throws nothing.
View framed(View view, const Surface& surface);

/// The artist's view of an object from where a camera looks: its direction and up, in the object's space,
/// locked; name and framing are still to be set. `objectToWorld` is invertible.
View viewFromCamera(const scene::Camera& camera, const glm::mat4& objectToWorld);

/// A view ready to project many points.
class Projector {
public:
    explicit Projector(const View& view);

    /// Where a point lies in the map: x right, y down, in texels, the first texel's centre at (0.5, 0.5).
    /// z is the depth in front of the eye, in units of the object.
    glm::dvec3 project(const glm::dvec3& point) const;
    /// Texture coordinates (§4.3): the place in the map over its side, in [0, 1], y down.
    glm::dvec2 textureCoordinates(const glm::dvec3& point) const {
        return glm::dvec2(project(point)) / double(m_size);
    }
    /// Unit vector from a point towards the eye.
    glm::dvec3 towardsEye(const glm::dvec3& point) const;
    /// n.v: the cosine between a unit normal and the direction towards the eye, in [-1, 1].
    double facing(const glm::dvec3& point, const glm::dvec3& normal) const {
        return glm::dot(normal, towardsEye(point));
    }
    /// The smallest n.v over a face's corners; -1 for a face without area.
    double facing(const Surface& surface, std::uint32_t face) const;
    /// The weight of the view's texture at a point (§4.3): max(n.v, epsilon), so that stretched faces count
    /// little. For smooth weights give a vertex with its own normal.
    double alpha(const glm::dvec3& point, const glm::dvec3& normal, double epsilon) const {
        return std::max(facing(point, normal), epsilon);
    }
    bool perspective() const { return m_perspective; }

private:
    glm::dmat3 m_basis;
    glm::dvec3 m_eye;
    double m_scale;  ///< texels a unit at the target's depth; in perspective, at depth 1
    double m_size;
    bool m_perspective;
};

}  // namespace chiaro::views
