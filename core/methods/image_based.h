#pragma once

#include "core/base/parameters.h"
#include "core/methods/method.h"
#include "core/methods/object_guide.h"
#include "core/synthesis/quilting.h"

namespace chiaro::methods {

/// Image-based synthesis (§4.1): the sample's texture is quilted right into the picture, each block from
/// where the sample is about as light as the object is there. The report's best-looking method; the gradient
/// and the lights may change afterwards without another synthesis. Takes any guide of light and object ids,
/// whether or not a mesh made it.
struct ImageBasedParams {
    int window = 4;  ///< k: how far from its light's place in the sample a block may come, in blocks, 0..64
    synthesis::QuiltParams quilt;
    static const ParameterTable<ImageBasedParams>& table();  ///< all but `quilt`
    friend bool operator==(const ImageBasedParams&, const ImageBasedParams&) = default;
};

/// One object's paint. What it points to must stay while it is used.
struct SampleTexture {
    const ColorImage* pixels = nullptr;  ///< the difference texture of a sample; its width decides the window
    /// The same prepared for searches: made once, it serves all frames of an animation. Without it every
    /// synthesis makes one for each different texture
    const synthesis::SearchTexture* prepared = nullptr;

    SampleTexture(const ColorImage* texture, const synthesis::SearchTexture* search = nullptr)
        : pixels(texture), prepared(search) {}
};
using SampleTextures = std::vector<SampleTexture>;

/// The texture that one object wears in a view: a part of the picture as large as the object's bounding box.
struct ObjectTexture {
    glm::ivec2 origin{0};  ///< of its top left pixel in the picture
    ColorImage pixels;     ///< difference RGB, 0 where the object isn't; empty when it isn't in the view
    synthesis::PixelMask covered;  ///< not 0 where it is
};

/// What a view's objects wear; [k - 1] belongs to object k.
struct ImageBasedTexture {
    std::vector<ObjectTexture> objects;
    synthesis::QuiltReport report;  ///< over all objects
};

/// The source positions that a block of mean light L' in [0, 1] may come from: their centres lie within
/// `window` blocks of L' * (width of the sample). At its ends the window is clamped inside and never emptied;
/// with a window of 0 it is the nearest position. All rows.
synthesis::CandidateArea windowAround(double light, int window, int block, const ColorImage& sample);

/// Texture of an object that is known beforehand, as large as its guide.
struct KnownTexture {
    ColorImage pixels;
    synthesis::PixelMask where;  ///< not 0 where it says something; empty when nothing is known
};

/// A view to quilt and what is known of it; [k - 1] of each list belongs to object k.
struct ImageBasedTask {
    std::vector<ObjectGuide> guides;
    std::vector<KnownTexture> filled;    ///< stays as it is and is continued; empty, or one an object
    std::vector<KnownTexture> previous;  ///< to stay close to: the frame before; empty, or one an object
    double previousWeight = 0;  ///< of its mean squared error against that of the overlaps, at least 0
};

/// Quilts a texture for every object of the view; samples[k - 1] belongs to object k, and several objects may
/// share one. An object has texture wherever its pixels' centres or their finer samples see it, so that
/// silhouettes and borders find texture on both sides; no object's texture says anything to another's.
/// Objects and blocks run in parallel; the bytes depend on the arguments alone. Throws Error when the view
/// shows an object without a sample or a parameter is out of range; Cancelled.
ImageBasedTexture synthesizeImageBased(const scene::GBuffer& gbuffer, const SampleTextures& samples,
                                       const ImageBasedParams& params, const Task& task = {});
/// The same from guides, with what is known of their texture.
ImageBasedTexture synthesizeImageBased(const ImageBasedTask& view, const SampleTextures& samples,
                                       const ImageBasedParams& params, const Task& task = {});

/// The picture: clip(G(L) + texture). `gradients` and the view's light may be others than the texture was
/// made with, its objects must lie where they did. Throws Cancelled.
Frame shadeImageBased(const scene::GBuffer& gbuffer, const std::vector<const gradient::Gradient*>& gradients,
                      const ImageBasedTexture& texture, const Task& task = {});

}  // namespace chiaro::methods
