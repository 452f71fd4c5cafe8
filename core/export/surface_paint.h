#pragma once

#include "core/export/surface_light.h"
#include "core/methods/view_dependent.h"

namespace chiaro::exporting {

/// How the textures of an object's views meet on its surface.
enum class Meeting {
    Agreed,   ///< of textures that propagated from view to view: as the view-dependent method blends them
    Pictures  ///< of pictures that know nothing of each other: almost only the view that faces a place best
              ///< shows there, and between two of them the contrast is kept
};

/// Shades any place of a scene's objects as the methods do (§4), without a camera.
class SurfacePaint {
public:
    /// paints[i] belongs to object i of the light's scene; all that is referred to must stay while this is
    /// used. An object without textures of its views shows G(L) alone. Paint that follows the camera does
    /// not.
    SurfacePaint(const SurfaceLight& light, std::vector<methods::ViewDependentPaint> paints,
                 methods::ViewDependentParams params, Meeting meeting);

    /// clip(G(L) + texture), display-referred; barycentrics weigh the face's second and third corner.
    glm::vec3 color(std::size_t object, std::uint32_t face, glm::vec2 barycentrics) const;

private:
    glm::vec3 ofPictures(const methods::PaintedObject& painted, std::uint32_t face,
                         glm::vec2 barycentrics) const;

    const SurfaceLight& m_light;
    std::vector<methods::ViewDependentPaint> m_paints;
    methods::ViewDependentParams m_params;
    Meeting m_meeting;
};

}  // namespace chiaro::exporting
