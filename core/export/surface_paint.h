#pragma once

#include "core/methods/view_dependent.h"
#include "core/scene/scene.h"

namespace chiaro::exporting {

/// Which light a mesh takes along.
enum class Bake {
    Lit,     ///< the scene's: the colours that its pictures show
    Texture  ///< the same light L = 1/2 everywhere: the paint's middle colour with its strokes and nothing of
             ///< light and shadow, for a renderer that has lights of its own
};

/// How the textures of an object's views meet on its surface.
enum class Meeting {
    Agreed,   ///< of textures that propagated from view to view: as the view-dependent method blends them
    Pictures  ///< of pictures that know nothing of each other: almost only the view that faces a place best
              ///< shows there, and between two of them the contrast is kept
};

/// Shades any place of a scene's objects as the methods do (§4), without a camera.
class SurfacePaint {
public:
    /// paints[i] belongs to objects[i] and must stay while it is used, as must the scene. An object without
    /// textures of its views shows G(L) alone. Paint that follows the camera does not.
    SurfacePaint(const scene::Scene& scene, std::vector<methods::ViewDependentPaint> paints,
                 methods::ViewDependentParams params, Meeting meeting, Bake bake);

    /// L at a place on the front of a face; barycentrics weigh its second and third corner.
    float light(std::size_t object, std::uint32_t face, glm::vec2 barycentrics) const;
    /// clip(G(L) + texture), display-referred.
    glm::vec3 color(std::size_t object, std::uint32_t face, glm::vec2 barycentrics) const;

private:
    glm::vec3 ofPictures(const methods::PaintedObject& painted, std::uint32_t face,
                         glm::vec2 barycentrics) const;

    const scene::Scene& m_scene;
    std::vector<methods::ViewDependentPaint> m_paints;
    methods::ViewDependentParams m_params;
    Meeting m_meeting;
    Bake m_bake;
    std::vector<glm::mat3> m_normalMatrices;
};

}  // namespace chiaro::exporting
