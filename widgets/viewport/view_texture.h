#pragma once

#include "core/methods/difference_texels.h"
#include "core/methods/image_based.h"
#include "core/methods/view_aligned.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

#include <vector>

namespace chiaro::widgets {

/// The image-based texture of a view (§4.1), as it is shown in that view and, until there is another, in
/// those that follow: each object takes its part along. Beyond what the object covered the texture goes on
/// mirrored at its outline, so that what comes into view wears paint as well.
struct ViewTexture {
    struct Object {
        glm::ivec2 origin{0};  ///< of the top left texel in the picture; may lie outside it
        Image<methods::DifferenceTexel>
            texels;              ///< one a pixel of the view; empty when the object wasn't in it
        glm::mat4 transform{1};  ///< object to world
    };
    std::vector<Object> objects;  ///< one an object of the scene
    methods::DifferenceRange range;
    scene::Camera camera;  ///< of the view it was made for,
    int width = 0;         ///< and its size in device pixels
    int height = 0;

    /// The difference at a position in the picture that it was made for, in pixels; bilinear, and mirrored
    /// outside the texels. 0 for an object that wasn't in view.
    glm::vec3 difference(std::size_t object, glm::vec2 position) const;
    /// How the objects moved on the screen since then, one an object of the scene: a position p in a view of
    /// so many pixels shows what was at (p - offset) / zoom.
    std::vector<methods::TexturePlacement> motions(const scene::Scene& scene, const scene::Camera& now,
                                                   int nowWidth, int nowHeight) const;
    std::size_t bytes() const;
};

/// What synthesizeImageBased made for a view of the scene of so many pixels, ready to show. Safe from any
/// thread. Throws Cancelled.
ViewTexture viewTexture(const methods::ImageBasedTexture& made, const scene::Scene& scene,
                        const scene::Camera& camera, int width, int height, const Task& task = {});

}  // namespace chiaro::widgets
