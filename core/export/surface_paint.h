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

/// Shades any place of a scene's objects as the methods do (§4), without a camera.
class SurfacePaint {
public:
    /// paints[i] belongs to objects[i] and must stay while it is used, as must the scene. An object without
    /// textures of its views shows G(L) alone. Paint that follows the camera does not.
    SurfacePaint(const scene::Scene& scene, std::vector<methods::ViewDependentPaint> paints,
                 methods::ViewDependentParams params, Bake bake);

    /// L at a place on the front of a face; barycentrics weigh its second and third corner.
    float light(std::size_t object, std::uint32_t face, glm::vec2 barycentrics) const;
    /// clip(G(L) + texture), display-referred.
    glm::vec3 color(std::size_t object, std::uint32_t face, glm::vec2 barycentrics) const;

    const std::vector<methods::ViewDependentPaint>& paints() const { return m_paints; }

private:
    const scene::Scene& m_scene;
    std::vector<methods::ViewDependentPaint> m_paints;
    methods::ViewDependentParams m_params;
    Bake m_bake;
    std::vector<glm::mat3> m_normalMatrices;
};

}  // namespace chiaro::exporting
