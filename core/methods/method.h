#pragma once

#include "core/base/image.h"
#include "core/gradient/gradient.h"
#include "core/scene/gbuffer.h"

namespace chiaro::methods {

/// The texture at a pixel of an object: difference RGB in [-1, 1], §4's second summand. Given to shade() by
/// each method.
using TextureLookup = std::function<glm::vec3(std::uint16_t object, int x, int y, float light)>;

/// The pixel whose centre speaks for an object at a pixel that shows it: itself, or beside the object's
/// border a neighbour; (-1, -1) when none does.
glm::ivec2 pixelShowing(const scene::GBuffer& gbuffer, std::uint16_t object, glm::ivec2 pixel);

/// A finished picture: RGB and coverage.
struct Frame {
    ColorAlphaImage
        picture;  ///< display-referred, not premultiplied; alpha is the share of the pixel that objects cover
    ColorImage texture;  ///< the texture summand alone, at pixel centres, 0 outside
};

/// Final colour = clip(G(L) + texture), the gradient looked up per sample at full frequency (§4), averaged
/// over each edge pixel's samples. gradients[k - 1] is the gradient of object k. Rows in parallel.
Frame shade(const scene::GBuffer& gbuffer, const std::vector<const gradient::Gradient*>& gradients,
            const TextureLookup& texture, const Task& task = {});

/// The picture over an opaque background.
ColorImage over(const ColorAlphaImage& picture, glm::vec3 background);

}  // namespace chiaro::methods
