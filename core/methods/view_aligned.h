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
    glm::mat4 objectToView{1};
    glm::mat4 projection{1};  ///< view to OpenGL clip space
    int width = 0;            ///< viewport, pixels
    int height = 0;
};

/// The placement after the object moved from one view to the next (§4.2): the offset grows by the mean screen
/// displacement of the tenth of the vertices in view with the largest n.v; hidden ones count too. Zoom is the
/// change of projected size at those vertices; with followZoom the texture is scaled about their mean, so it
/// does not slide. A mesh of more than 16,384 vertices is represented by an even sample of them. An object
/// out of view keeps its placement.
TexturePlacement follow(const TexturePlacement& placement, const scene::Mesh& mesh, const ObjectView& before,
                        const ObjectView& after, const ViewAlignedParams& params);

/// The two octaves of the texture that a zoom cross-fades. Zooming in by 2 magnifies the first, then, within
/// the middle third of the way (in steps of equal zoom), the second, twice as fine, takes its place and ends
/// as the first began: no jump, strokes keep their size within a factor of 2^(2/3), and two thirds of all
/// zooms show one octave, which costs half.
struct ZoomOctaves {
    float scale = 1;  ///< texture pixels per screen pixel of the first octave, before density; in (0.5, 1]
    float nextScale = 2;  ///< of the second
    float weight = 0;     ///< of the first, and
    float nextWeight =
        0;  ///< of the second: their squares add up to 1, which keeps the contrast of zero-mean textures
};
ZoomOctaves zoomOctaves(float zoom);

/// One object's paint, ready for the 3D texture.
struct ViewAlignedPaint {
    const synthesis::LevelStack* levels = nullptr;
    const gradient::Gradient* gradient = nullptr;
    TexturePlacement placement;
};

/// The texture at screen position (x, y) in pixels and light in [0, 1] (§4.2): s, t = (position - offset) *
/// density / n, r = light; trilinear, s and t repeat, level i is centred at (i + 0.5) / count and the ends
/// are clamped. Where more than one texel falls on a pixel, 2 x 2 taps (4 x 4 above two) spread evenly over
/// the pixel's texels are averaged.
glm::vec3 viewAlignedTexture(const ViewAlignedPaint& paint, const ViewAlignedParams& params,
                             glm::vec2 position, float light);

/// The CPU reference picture; paints[k - 1] belongs to object k. Deterministic. Throws Cancelled.
Frame renderViewAligned(const scene::GBuffer& gbuffer, const std::vector<ViewAlignedPaint>& paints,
                        const ViewAlignedParams& params, const Task& task = {});

}  // namespace chiaro::methods
