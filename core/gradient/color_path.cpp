#include "core/gradient/color_path.h"

#include "core/base/color.h"
#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <sstream>

namespace chiaro::gradient {

glm::vec3 ColorPath::at(float x) const {
    const auto after =
        std::upper_bound(stops.begin(), stops.end(), x,
                         [](float place, const ColorStop& stop) { return place < stop.position; });
    if (after == stops.begin()) return glm::clamp(stops.front().color, 0.0f, 1.0f);
    if (after == stops.end()) return glm::clamp(stops.back().color, 0.0f, 1.0f);
    const ColorStop& left = *(after - 1);
    const float fraction = (x - left.position) / (after->position - left.position);
    const glm::vec3 color =
        space == Space::Rgb
            ? glm::mix(left.color, after->color, fraction)
            : srgbFromOklab(glm::mix(oklabFromSrgb(left.color), oklabFromSrgb(after->color), fraction));
    return glm::clamp(color, 0.0f, 1.0f);
}

std::vector<glm::vec3> ColorPath::sampled(int count) const {
    std::vector<glm::vec3> colors;
    for (int i = 0; i < count; ++i) colors.push_back(at(count > 1 ? float(i) / float(count - 1) : 0.0f));
    return colors;
}

ColorPath parseColorPath(std::string_view text, ColorPath::Space space) {
    ColorPath path{{}, space};
    std::istringstream stream{std::string(text)};
    for (std::string part; std::getline(stream, part, ',');) {
        std::istringstream fields(part);
        ColorStop stop;
        std::string color, excess;
        const bool complete = fields >> stop.position >> color && !(fields >> excess);
        if (!complete || !(stop.position >= 0 && stop.position <= 1))
            throw Error(fmt::format("colour stop \"{}\"", part), "can't be read",
                        "write a position from 0 to 1 and a colour, for example 0.5 #c04020");
        stop.color = colorFromHex(color);
        path.stops.push_back(stop);
    }
    if (path.stops.empty())
        throw Error("colour path", "has no stops", "write for example 0 #201040, 0.5 #c04020, 1 #fff0b0");
    std::stable_sort(path.stops.begin(), path.stops.end(),
                     [](const ColorStop& a, const ColorStop& b) { return a.position < b.position; });
    return path;
}

std::string colorPathText(const ColorPath& path) {
    std::string text;
    for (const ColorStop& stop : path.stops)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", stop.position, hexFromColor(stop.color));
    return text;
}

}  // namespace chiaro::gradient
