#pragma once

#include "core/base/parameters.h"
#include "core/methods/method.h"
#include "core/synthesis/levels.h"

namespace chiaro::methods {

/// View-aligned 3D texture (§4.2): the level stack as the slices of a 3D texture, fixed to the screen but for
/// an offset that follows each object. Real time; strokes keep their size and face the viewer; they slide
/// where the surface turns.
struct ViewAlignedParams {
    double density = 1;      ///< texture pixels per screen pixel, 0.1..10
    bool followZoom = true;  ///< let the texture scale follow the object in octaves that cross-fade
    static const ParameterTable<ViewAlignedParams>& table();
    friend bool operator==(const ViewAlignedParams&, const ViewAlignedParams&) = default;
};

/// Where an object's texture lies on the screen.
struct TexturePlacement {
    glm::vec2 offset{0};  ///< pixels, x right, y down; subtracted from the screen position
    float zoom = 1;       ///< the object's size on screen relative to when it was first seen, > 0
    friend bool operator==(const TexturePlacement&, const TexturePlacement&) = default;
};

/// A pose of an object in a view, from which its screen motion is measured.
struct ObjectView {
    glm::mat4 objectToClip{1};  ///< projection * view * transform
    glm::mat4 objectToView{1};
    int width = 0;  ///< viewport, pixels
    int height = 0;
};

/// The placement after the object moved from one view to the next: the offset grows by the mean screen
/// displacement of the tenth of the visible vertices with the largest n.v (§4.2), the zoom by the change of
/// projected size.
TexturePlacement follow(const TexturePlacement& placement, const scene::Mesh& mesh, const ObjectView& before,
                        const ObjectView& after);

/// Octave cross-fade of a zoom: texel scale of the finer and the coarser octave, and the weight of the
/// coarser in [0, 1].
struct ZoomOctaves {
    float scale = 1;  ///< texture pixels per screen pixel of the first octave, before density
    float nextScale = 0.5f;
    float weight = 0;  ///< of the second
};
ZoomOctaves zoomOctaves(float zoom);

/// One object's paint, ready for the 3D texture.
struct ViewAlignedPaint {
    const synthesis::LevelStack* levels = nullptr;
    const gradient::Gradient* gradient = nullptr;
    TexturePlacement placement;
};

/// The texture at screen position (x, y) in pixels and light in [0, 1]: trilinear in the stack; s, t repeat,
/// levels clamp (§4.2).
glm::vec3 viewAlignedTexture(const ViewAlignedPaint& paint, const ViewAlignedParams& params,
                             glm::vec2 position, float light);

/// The CPU reference picture; paints[k - 1] belongs to object k. Deterministic.
Frame renderViewAligned(const scene::GBuffer& gbuffer, const std::vector<ViewAlignedPaint>& paints,
                        const ViewAlignedParams& params, const Task& task = {});

}  // namespace chiaro::methods
