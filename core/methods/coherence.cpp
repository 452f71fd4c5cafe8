#include "core/methods/coherence.h"

#include <cmath>

namespace chiaro::methods {

const ParameterTable<CoherenceParams>& CoherenceParams::table() {
    static const auto table =
        ParameterTable<CoherenceParams>()
            .add(&CoherenceParams::mode,
                 ParameterSpec::choice(
                     "coherence", "Coherence", {"independent", "previous", "keyframes", "reprojected"},
                     "How the frames of an image-based animation hang together: each by itself, close "
                     "to the one before, blended from keyframe to keyframe, or moved with "
                     "the surface."))
            .add(&CoherenceParams::every,
                 ParameterSpec::integer("every", "Keyframe distance", "frames", 1, 240,
                                        "Frames from one keyframe's texture to the next: more is calmer and "
                                        "faster, less follows the light and the camera more closely."))
            .add(&CoherenceParams::blend,
                 ParameterSpec::choice("blend", "Blend", {"linear", "preserving"},
                                       "Between keyframes: linear fades softly and greys a little half way, "
                                       "preserving keeps the contrast of the strokes."))
            .add(&CoherenceParams::temporalWeight,
                 ParameterSpec::real("temporal-weight", "Temporal weight", "", 0, 100, 0.25,
                                     "How strongly a frame stays close to the one before, against how well "
                                     "its pieces fit together."))
            .add(&CoherenceParams::reproject,
                 ParameterSpec::choice("reproject", "Moved texture", {"keyframes", "previous"},
                                       "What moves with the surface: the keyframes' textures, or the frame "
                                       "before as what the next one stays close to."));
    return table;
}

bool CoherenceParams::hasKeyframes() const {
    return mode == Coherence::Keyframes ||
           (mode == Coherence::Reprojected && reproject == Reprojection::Keyframes);
}

glm::vec3 blended(Blend blend, glm::vec3 first, float firstWeight, glm::vec3 second, float secondWeight) {
    const float norm = blend == Blend::Linear
                           ? firstWeight + secondWeight
                           : std::sqrt(firstWeight * firstWeight + secondWeight * secondWeight);
    return norm > 0 ? (firstWeight * first + secondWeight * second) / norm : glm::vec3(0);
}

}  // namespace chiaro::methods
