#pragma once

#include "core/methods/image_based.h"
#include "core/scene/motion.h"

#include <memory>

namespace chiaro::methods {

/// What a frame of an animation shows.
struct FrameView {
    std::shared_ptr<const scene::GBuffer> gbuffer;
    scene::Camera camera;
};

/// The image-based texture of a frame.
struct FrameTexture {
    FrameView view;
    ImageBasedTexture texture;
};

/// An object's texture as another frame hands it on, as large as the object's guide in this frame.
struct CarriedTexture {
    ColorImage pixels;
    ScalarImage confidence;  ///< how far to trust it, in [0, 1]; 0 where the other frame has nothing
};

/// The texture that stays where it is in the picture.
CarriedTexture stayed(const ObjectTexture& texture, const ObjectGuide& guide);

/// The texture moved as the surface moves from another frame to this one: each pixel takes what its surface
/// point wears there. `seen` tells where this frame's surface points lie in that one (scene::seenFrom).
/// Confidence falls as the surface turned away from the eye there, where the texture is stretched, and is 0
/// where it was hidden.
CarriedTexture moved(const FrameTexture& from, std::size_t object, const ObjectGuide& guide,
                     const scene::GBuffer& gbuffer, const Image<scene::SeenPoint>& seen);

}  // namespace chiaro::methods
