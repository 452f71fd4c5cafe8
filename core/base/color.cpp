#include "core/base/color.h"

#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>

#include <array>

namespace chiaro {

float linearFromSrgb(float encoded) {
    const float magnitude = std::abs(encoded);
    const float linear =
        magnitude <= 0.04045f ? magnitude / 12.92f : std::pow((magnitude + 0.055f) / 1.055f, 2.4f);
    return std::copysign(linear, encoded);
}

float srgbFromLinear(float linear) {
    const float magnitude = std::abs(linear);
    const float encoded =
        magnitude <= 0.0031308f ? magnitude * 12.92f : 1.055f * std::pow(magnitude, 1 / 2.4f) - 0.055f;
    return std::copysign(encoded, linear);
}

glm::vec3 linearFromSrgb(glm::vec3 encoded) {
    return {linearFromSrgb(encoded.r), linearFromSrgb(encoded.g), linearFromSrgb(encoded.b)};
}

glm::vec3 srgbFromLinear(glm::vec3 linear) {
    return {srgbFromLinear(linear.r), srgbFromLinear(linear.g), srgbFromLinear(linear.b)};
}

namespace {

// Ottosson's two matrices, written as GLM wants them: column by column.
const glm::mat3 conesFromLinear(0.4122214708f, 0.2119034982f, 0.0883024619f,  //
                                0.5363325363f, 0.6806995451f, 0.2817188376f,  //
                                0.0514459929f, 0.1073969566f, 0.6299787005f);
const glm::mat3 oklabFromCones(0.2104542553f, 1.9779984951f, 0.0259040371f,   //
                               0.7936177850f, -2.4285922050f, 0.7827717662f,  //
                               -0.0040720468f, 0.4505937099f, -0.8086757660f);
const glm::mat3 linearFromCones = glm::inverse(conesFromLinear);
const glm::mat3 conesFromOklab = glm::inverse(oklabFromCones);

}  // namespace

glm::vec3 oklabFromSrgb(glm::vec3 encoded) {
    const glm::vec3 cones = conesFromLinear * linearFromSrgb(encoded);
    return oklabFromCones * glm::vec3(std::cbrt(cones.x), std::cbrt(cones.y), std::cbrt(cones.z));
}

glm::vec3 srgbFromOklab(glm::vec3 oklab) {
    const glm::vec3 roots = conesFromOklab * oklab;
    return srgbFromLinear(linearFromCones * (roots * roots * roots));
}

glm::vec3 colorFromHex(std::string_view text) {
    const auto invalid = [&] {
        return Error("colour \"" + std::string(text) + "\"", "not a hexadecimal colour",
                     "write it as #rrggbb, for example #c04020");
    };
    if ((text.size() != 7 && text.size() != 4) || text.front() != '#') throw invalid();
    const std::size_t digits = (text.size() - 1) / 3;
    glm::vec3 color(0);
    for (int channel = 0; channel < 3; ++channel) {
        int value = 0;
        for (std::size_t digit = 0; digit < digits; ++digit) {
            const char c = text[1 + std::size_t(channel) * digits + digit];
            const std::size_t nibble = std::string_view("0123456789abcdef").find(char(std::tolower(c)));
            if (nibble == std::string_view::npos) throw invalid();
            value = value * 16 + int(nibble);
        }
        color[channel] = float(digits == 1 ? value * 17 : value) / 255.0f;
    }
    return color;
}

std::string hexFromColor(glm::vec3 color) {
    const glm::ivec3 bytes(glm::round(glm::clamp(color, 0.0f, 1.0f) * 255.0f));
    return fmt::format("#{:02x}{:02x}{:02x}", bytes.r, bytes.g, bytes.b);
}

}  // namespace chiaro
