#include "widgets/path_through.h"

#include <algorithm>

namespace chiaro::widgets {

namespace {

/// How far the colour at `index` lies from the straight line between two others.
float deviation(const std::vector<glm::vec3>& colors, std::size_t from, std::size_t to, std::size_t index) {
    const float share = float(index - from) / float(to - from);
    return glm::distance(colors[index], glm::mix(colors[from], colors[to], share));
}

}  // namespace

gradient::ColorPath pathThrough(const std::vector<glm::vec3>& colors, int maximumStops) {
    constexpr float closeEnough = 0.012F;
    std::vector<std::size_t> kept{0, colors.size() - 1};
    // Ramer, Douglas and Peucker's worst point, taken greedily until the path is close or has enough stops.
    while (int(kept.size()) < maximumStops) {
        float worst = closeEnough;
        std::size_t place = 0;
        for (std::size_t i = 0; i + 1 < kept.size(); ++i)
            for (std::size_t index = kept[i] + 1; index < kept[i + 1]; ++index)
                if (const float away = deviation(colors, kept[i], kept[i + 1], index); away > worst) {
                    worst = away;
                    place = index;
                }
        if (place == 0) break;
        kept.insert(std::upper_bound(kept.begin(), kept.end(), place), place);
    }
    gradient::ColorPath path;
    for (std::size_t index : kept)
        path.stops.push_back({float(index) / float(colors.size() - 1), colors[index]});
    return path;
}

}  // namespace chiaro::widgets
