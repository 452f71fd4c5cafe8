#include "core/export/chart_packing.h"

#define STB_RECT_PACK_IMPLEMENTATION
#define STBRP_STATIC
#include <stb/stb_rect_pack.h>

#include <algorithm>
#include <cmath>

namespace chiaro::exporting {

namespace {

/// The largest scale is found to within this factor.
constexpr double accuracy = 1.004;
/// Charts that fill less of the atlas than this had better have less padding, but not less than some texels.
constexpr double leastFilled = 0.15;
constexpr int leastPadding = 2;

class Packer {
public:
    Packer(const std::vector<Chart>& charts, int size)
        : m_charts(charts), m_size(size), m_rectangles(charts.size()), m_nodes(std::size_t(size)) {}

    /// Empty when the charts don't fit.
    std::optional<ChartPacking> pack(double scale, int padding) {
        std::int64_t area = 0;
        const std::int64_t most = std::int64_t(m_size) * m_size;
        for (std::size_t i = 0; i < m_charts.size(); ++i) {
            const glm::dvec2 sides = glm::ceil(m_charts[i].size * scale) + double(padding);
            if (std::max(sides.x, sides.y) > m_size) return {};
            stbrp_rect& rectangle = m_rectangles[i];
            rectangle = {int(i), std::max(int(sides.x), 1), std::max(int(sides.y), 1), 0, 0, 0};
            area += std::int64_t(rectangle.w) * rectangle.h;
        }
        if (area > most) return {};
        stbrp_context context;
        stbrp_init_target(&context, m_size, m_size, m_nodes.data(), int(m_nodes.size()));
        if (stbrp_pack_rects(&context, m_rectangles.data(), int(m_rectangles.size())) == 0) return {};
        ChartPacking packing{scale, padding, {}};
        for (const stbrp_rect& rectangle : m_rectangles)
            packing.origins.push_back(glm::dvec2(rectangle.x, rectangle.y) + padding / 2.0);
        return packing;
    }

private:
    const std::vector<Chart>& m_charts;
    int m_size;
    std::vector<stbrp_rect> m_rectangles;
    std::vector<stbrp_node> m_nodes;
};

}  // namespace

std::optional<ChartPacking> packCharts(const std::vector<Chart>& charts, int size, int padding,
                                       const Task& task) {
    double area = 0, longest = 0;
    for (const Chart& chart : charts) {
        area += chart.size.x * chart.size.y;
        longest = std::max({longest, chart.size.x, chart.size.y});
    }
    Packer packer(charts, size);
    if (!(longest > 0)) return packer.pack(1, 0);
    // At this scale the charts' own boxes would fill the atlas; at the least one the longest is a texel long.
    const double highest = std::min(double(size) * size / std::max(area, 1e-300), 1e300);
    const double most = std::min(std::sqrt(highest), size / longest);
    const double least = std::min(1 / longest, most);
    for (;; padding /= 2) {
        std::optional<ChartPacking> best;
        double high = most;
        for (double scale = most * 0.9; !best && scale >= least; scale *= 0.8) {
            task.checkpoint();
            best = packer.pack(scale, padding);
            if (!best) high = scale;
        }
        while (best && high / best->scale > accuracy) {
            task.checkpoint();
            const double middle = std::sqrt(best->scale * high);
            if (auto better = packer.pack(middle, padding))
                best = std::move(better);
            else
                high = middle;
        }
        const bool isFilled = best && area * best->scale * best->scale > leastFilled * size * size;
        if (isFilled || (best && padding < 2 * leastPadding) || padding == 0) return best;
    }
}

}  // namespace chiaro::exporting
