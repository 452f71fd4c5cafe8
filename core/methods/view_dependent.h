#pragma once

#include "core/base/parameters.h"
#include "core/methods/coherence.h"
#include "core/methods/method.h"
#include "core/methods/view_weights.h"

namespace chiaro::methods {

/// View-dependent textures (§4.3): every object has textures of its own, quilted from a dozen views and
/// blended on its surface, so that strokes stay where they are on it. Real time once they are made.
struct ViewDependentParams {
    bool propagate = true;        ///< let a view go on from what the views before painted on shared faces
    bool followCamera = false;    ///< views near the camera's count more
    Blend blend = Blend::Linear;  ///< of the textures that meet at a place
    static const ParameterTable<ViewDependentParams>& table();
    friend bool operator==(const ViewDependentParams&, const ViewDependentParams&) = default;
};

/// An object's views with their textures: what a picture takes.
struct PaintedObject {
    std::shared_ptr<const PlannedObject> planned;
    std::shared_ptr<const ViewWeights> weights;
    ViewTextures textures;
};

/// One object's paint, ready for a picture.
struct ViewDependentPaint {
    const PaintedObject* object = nullptr;  ///< null: G(L) alone is shown
    const gradient::Gradient* gradient = nullptr;
    glm::vec3 eye{0};  ///< of the camera, object space; only read with followCamera
};

/// The texture of a place on a face: that of each of its views, level by L as in the 3D texture (level i is
/// centred at (i + 0.5) / count), blended by their weights. `barycentrics` weigh the second and third corner.
glm::vec3 viewDependentTexture(const ViewDependentPaint& paint, const ViewDependentParams& params,
                               std::uint32_t face, glm::vec2 barycentrics, float light);

/// The CPU reference picture; paints[k - 1] belongs to object k. Deterministic. Throws Cancelled.
Frame renderViewDependent(const scene::GBuffer& gbuffer, const std::vector<ViewDependentPaint>& paints,
                          const ViewDependentParams& params, const Task& task = {});

}  // namespace chiaro::methods
