#pragma once

#include <glm/glm.hpp>

#include <string>
#include <string_view>

namespace chiaro {

/// sRGB transfer function, one channel or three; extended below 0 by symmetry and above 1 by the same
/// formula.
float linearFromSrgb(float encoded);
float srgbFromLinear(float linear);
glm::vec3 linearFromSrgb(glm::vec3 encoded);
glm::vec3 srgbFromLinear(glm::vec3 linear);

/// Oklab (Ottosson 2020) of a display-referred colour: x = L in [0, 1], y = a, z = b.
glm::vec3 oklabFromSrgb(glm::vec3 encoded);
glm::vec3 srgbFromOklab(glm::vec3 oklab);

/// `#rrggbb` or `#rgb`, in [0, 1]. Throws Error when the text is anything else.
glm::vec3 colorFromHex(std::string_view text);
/// `#rrggbb`; components outside [0, 1] are clipped.
std::string hexFromColor(glm::vec3 color);

}  // namespace chiaro
