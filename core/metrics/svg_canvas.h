#pragma once

#include "core/metrics/chart_canvas.h"

namespace chiaro::metrics {

/// Charts as SVG 1.1, which any browser or text processor shows.
class SvgCanvas : public ChartCanvas {
public:
    explicit SvgCanvas(glm::dvec2 size);
    void moveTo(glm::dvec2 origin) override { m_origin = origin; }
    void text(glm::dvec2 place, const std::string& text, Anchor anchor, Lettering lettering) override;
    void line(std::span<const glm::dvec2> points, Stroke stroke, unsigned color) override;
    void dot(glm::dvec2 place, unsigned color, const std::string& words) override;
    /// The whole file.
    std::string svg() const { return m_svg + "</svg>\n"; }

private:
    glm::dvec2 m_origin{0};
    std::string m_svg;
};

}  // namespace chiaro::metrics
