#pragma once

#include "core/base/image.h"
#include "core/base/parameters.h"

namespace chiaro::methods {

/// How the frames of an image-based animation hang together (§4.1). Strokes never lie still in all respects:
/// what is fixed to the picture slides over the object, and what is fixed to the object changes its size.
enum class Coherence {
    Independent,  ///< every frame from scratch: the strokes jump
    Previous,     ///< every frame stays close to the one before, by a term in the search's error
    Keyframes,    ///< a texture every n-th frame, blended between; fixed to the picture
    Reprojected   ///< as the one or the other, but the older texture is first moved as the surface moves
};

/// How two textures are laid over each other on the way from one keyframe to the next.
enum class Blend {
    Linear,     ///< as the report does; half way the contrast of unrelated strokes falls to 0.7
    Preserving  ///< divided by sqrt(sum of squared weights): contrast stays (Heitz and Neyret 2018)
};

/// What Coherence::Reprojected moves.
enum class Reprojection { Keyframes, Previous };

struct CoherenceParams {
    Coherence mode = Coherence::Keyframes;
    int every = 8;                ///< frames from one keyframe to the next, 1..240
    Blend blend = Blend::Linear;  ///< between keyframes
    double temporalWeight = 1;    ///< of the squared difference to the frame before, 0..100
    Reprojection reproject = Reprojection::Keyframes;
    static const ParameterTable<CoherenceParams>& table();
    /// Whether a frame can be made without those before it but for the keyframes on its both sides.
    bool hasKeyframes() const;
    /// Whether textures move with the surface.
    bool movesTextures() const { return mode == Coherence::Reprojected; }
    friend bool operator==(const CoherenceParams&, const CoherenceParams&) = default;
};

/// The mixture of two zero-mean textures, the weights of which needn't add up to 1; 0 where both are 0.
glm::vec3 blended(Blend blend, glm::vec3 first, float firstWeight, glm::vec3 second, float secondWeight);

}  // namespace chiaro::methods
