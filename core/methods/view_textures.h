#pragma once

#include "core/synthesis/levels.h"
#include "core/views/coverage.h"
#include "core/views/planning.h"

namespace chiaro::methods {

/// An object's surface and the views it is painted from. Immutable, shared by what is made of it.
struct PlannedObject {
    views::Surface surface;
    views::ViewPlan plan;
};

/// Plans an object's views (§4.3.1 to 3), with further ones of what they show steeply only. The map of the
/// view that shows most across is as large as the params say, the others as much smaller as they come closer:
/// strokes are then of one size from all views. Throws Error, Cancelled.
std::shared_ptr<const PlannedObject> planObject(std::shared_ptr<const scene::Mesh> mesh,
                                                const views::ViewParams& params,
                                                const std::vector<views::View>& kept = {},
                                                const Task& task = {});

/// A difference in [-1, 1] in 16 bits a channel: half the memory of float, and steps of 1/32767.
using PackedTexel = glm::i16vec3;
PackedTexel packed(glm::vec3 difference);
glm::vec3 unpacked(PackedTexel texel);

/// A view's texture: a stack of levels, darkest first, over the part of its map that its faces cover and some
/// texels around it, so that reading between texels never meets nothing.
struct ViewTexture {
    glm::ivec2 origin{0};  ///< of the levels' top left texel in the map
    std::vector<Image<PackedTexel>> levels;

    /// Linear between texels, at a position in the map (texels, a texel's centre at + 0.5); the nearest texel
    /// beyond the border.
    glm::vec3 at(std::size_t level, glm::vec2 position) const;
};

/// The textures of an object's views, [i] of group i of its plan; empty for a view without faces.
struct ViewTextures {
    std::vector<ViewTexture> views;
    synthesis::QuiltReport report;
};

/// Quilts every view's stack (§4.3.5), beginning with the view that overlaps most with the others and going
/// on with the one that overlaps most with those that are done. `sources` are the levels' (synthesis::
/// levelSources).
///
/// With `propagate`, where a view sees a face no better than one that is done, its texels are
/// copied from there by the face's affine map and count as filled; quilting continues around them with cuts
/// on any side. What was quilted anew is copied back into the views that are done. So each place of the
/// surface has one texture, made in a view that sees it well, and all views agree. The bytes depend on the
/// arguments alone. Throws Error, Cancelled.
ViewTextures synthesizeViews(const PlannedObject& object, const std::vector<synthesis::LevelSource>& sources,
                             bool propagate, const Task& task = {});

}  // namespace chiaro::methods
