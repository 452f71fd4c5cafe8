#pragma once

#include <glm/glm.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace chiaro::gradient {

/// A colour at a place on a path.
struct ColorStop {
    float position = 0;  ///< in [0, 1], 0 is the dark end
    glm::vec3 color{0};  ///< display-referred RGB in [0, 1]
    friend bool operator==(const ColorStop&, const ColorStop&) = default;
};

/// A path through colour space that the artist draws to recolour a sample (§3.2): stops in order of position,
/// interpolated linearly between them, constant beyond the first and the last.
struct ColorPath {
    enum class Space { Rgb, Oklab };
    std::vector<ColorStop> stops;
    Space space = Space::Rgb;
    friend bool operator==(const ColorPath&, const ColorPath&) = default;

    /// The colour at x in [0, 1]; the path must have a stop. Clipped to [0, 1].
    glm::vec3 at(float x) const;
    /// `count` colours at x = i / (count - 1).
    std::vector<glm::vec3> sampled(int count) const;
};

/// Reads '0 #201040, 0.5 #c04020, 1 #fff0b0'; sorts by position. Throws Error quoting what can't be read.
ColorPath parseColorPath(std::string_view text, ColorPath::Space space = ColorPath::Space::Rgb);
std::string colorPathText(const ColorPath& path);

}  // namespace chiaro::gradient
