#pragma once

#include "core/methods/method.h"
#include "widgets/viewport/view_state.h"

namespace chiaro::widgets {

/// What a view shows at one moment by one method, for another thread: values and shared immutable snapshots.
struct ViewSnapshot {
    scene::Scene scene;
    scene::Camera camera;
    std::vector<ViewportPaint> paints;  ///< one an object
    std::vector<methods::TexturePlacement> placements;
    std::string method;
    methods::ViewAlignedParams params;
    std::shared_ptr<const ViewTexture> viewTexture;
    std::vector<methods::TexturePlacement> motions;                      ///< of the view texture
    std::vector<std::shared_ptr<const methods::PaintedObject>> painted;  ///< one an object
    methods::ViewDependentParams viewDependent;
    glm::vec3 background{0};
    QSize pixels;  ///< device pixels

    /// The state as it is now by one of its methods, in a picture of so many device pixels; textures follow
    /// what moved.
    static ViewSnapshot of(ViewState& state, const std::string& method, QSize pixels);
};

/// Whether rays meet the same surfaces in both, so that a RayScene serves both.
bool sameSurfaces(const scene::Scene& a, const scene::Scene& b);

/// The picture of a snapshot by core, at its G-buffer of snapshot.pixels / coarseness. Throws Cancelled.
methods::Frame shaded(const ViewSnapshot& snapshot, const scene::GBuffer& gbuffer, int coarseness,
                      const Task& task);

}  // namespace chiaro::widgets
