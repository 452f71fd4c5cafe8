#pragma once

#include "core/methods/carried_texture.h"
#include "core/methods/coherence.h"

#include <map>

namespace chiaro::methods {

/// What an animation shows at each of its frames, 1 and later; all of one size. Throws Error, Cancelled.
using FrameViews = std::function<FrameView(int frame, const Task& task)>;

/// Image-based textures for the frames of an animation (§4.1). A frame's texture depends on the arguments and
/// its number alone, not on what was asked before, so that a shot may be split among machines: keyframes lie
/// at 1, 1 + n, 1 + 2n, .., and modes that build on the frame before begin at frame 1.
///
/// A keyframe's texture that stays in the picture covers an object wherever it comes until the keyframes
/// beside it. One that moves with the surface leaves pixels that neither keyframe has seen; quilting
/// continues into them.
class ImageBasedAnimation {
public:
    /// What the samples point to must stay while it is used.
    ImageBasedAnimation(FrameViews views, SampleTextures samples, const ImageBasedParams& params,
                        const CoherenceParams& coherence);

    /// The texture of a frame, 1 or later. Throws Error, Cancelled.
    ImageBasedTexture texture(int frame, const Task& task = {});

private:
    using SharedTexture = std::shared_ptr<const FrameTexture>;

    ImageBasedTexture fromKeyframes(int frame, const Task& task);
    ImageBasedTexture fromPrevious(int frame, const Task& task);
    SharedTexture keyframe(int index, const Task& task);
    std::vector<ObjectGuide> keyframeGuides(int index, const Task& task);
    SharedTexture nextFrame(const FrameTexture& last, int frame, const Task& task) const;
    std::vector<CarriedTexture> carried(const FrameTexture& from, const FrameView& to,
                                        const std::vector<ObjectGuide>& guides) const;

    FrameViews m_views;
    SampleTextures m_samples;
    ImageBasedParams m_params;
    CoherenceParams m_coherence;
    std::map<int, SharedTexture> m_keyframes;  ///< the two around the frame asked for last
    int m_lastFrame = 0;                       ///< of m_last; 0 before the first
    SharedTexture m_last;
};

}  // namespace chiaro::methods
