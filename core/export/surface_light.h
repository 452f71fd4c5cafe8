#pragma once

#include "core/scene/occlusion.h"
#include "core/scene/scene.h"

#include <memory>

namespace chiaro::exporting {

/// Which light a mesh takes along.
enum class Bake {
    Lit,     ///< the scene's: the colours that its pictures show
    Texture  ///< the same light L = 1/2 everywhere: the paint's middle colour with its strokes and nothing of
             ///< light and shadow, for a renderer that has lights of its own
};

/// The light of any place on the front of a scene's surfaces, as pictures have it: with shadows and ambient
/// occlusion if they are on. Immutable; from any thread.
class SurfaceLight {
public:
    /// The scene must stay while this is used. Throws Cancelled.
    SurfaceLight(const scene::Scene& scene, Bake bake, const Task& task = {});

    /// L in [0, 1]; barycentrics weigh the face's second and third corner.
    float at(std::size_t object, std::uint32_t face, glm::vec2 barycentrics) const;

private:
    /// What surfaces keep from each other.
    struct Occlusion {
        scene::RayScene rays;
        scene::OcclusionCaster caster;
        Occlusion(const scene::Scene& scene, const Task& task)
            : rays(scene, task), caster(rays.impl(), rays.occlusion(), scene.lights) {}
    };

    const scene::Scene& m_scene;
    Bake m_bake;
    std::vector<glm::mat3> m_normalMatrices;
    std::unique_ptr<const Occlusion> m_occlusion;  ///< null when it is off
};

}  // namespace chiaro::exporting
