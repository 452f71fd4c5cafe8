#include "core/metrics/svg_canvas.h"

#include <fmt/format.h>

#include <iterator>

namespace chiaro::metrics {

namespace {

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
        }
    }
    return result;
}

const char* classOf(Stroke stroke) {
    switch (stroke) {
        case Stroke::Grid:
            return "grid";
        case Stroke::Axis:
            return "axis";
        case Stroke::Bar:
            return "bar";
        default:
            return "curve";
    }
}

}  // namespace

SvgCanvas::SvgCanvas(glm::dvec2 size)
    : m_svg(fmt::format(
          R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}">
<style>text{{font:11px sans-serif;fill:#333}}.title{{font-weight:bold;font-size:13px}}.middle{{text-anchor:middle}}
.end{{text-anchor:end}}path{{fill:none}}.grid{{stroke:#e4e4e4}}.axis{{stroke:#555}}.bar{{opacity:.5}}
.curve{{stroke-width:1.8;stroke-linejoin:round}}</style>
<rect width="100%" height="100%" fill="#fff"/>
)",
          size.x, size.y)) {}

void SvgCanvas::text(glm::dvec2 place, const std::string& text, Anchor anchor, Lettering lettering) {
    const glm::dvec2 at = m_origin + place;
    const std::string where =
        anchor == Anchor::Upward
            ? fmt::format(R"svg(transform="translate({:.1f} {:.1f}) rotate(-90)")svg", at.x, at.y)
            : fmt::format(R"(x="{:.1f}" y="{:.1f}")", at.x, at.y);
    const char* const lies = anchor == Anchor::Start ? "start" : anchor == Anchor::End ? "end" : "middle";
    fmt::format_to(std::back_inserter(m_svg), "<text {} class=\"{}{}\">{}</text>\n", where, lies,
                   lettering == Lettering::Title ? " title" : "", escaped(text));
}

void SvgCanvas::line(std::span<const glm::dvec2> points, Stroke stroke, unsigned color) {
    std::string way;
    for (const glm::dvec2 point : points)
        way += fmt::format("{}{:.1f} {:.1f}", way.empty() ? "M" : "L", m_origin.x + point.x,
                           m_origin.y + point.y);
    const bool colored = stroke == Stroke::Bar || stroke == Stroke::Curve;
    fmt::format_to(std::back_inserter(m_svg), "<path d=\"{}\" class=\"{}\"{}/>\n", way, classOf(stroke),
                   colored ? fmt::format(R"( stroke="#{:06x}")", color) : std::string());
}

void SvgCanvas::dot(glm::dvec2 place, unsigned color, const std::string& words) {
    fmt::format_to(std::back_inserter(m_svg),
                   R"(<circle cx="{:.1f}" cy="{:.1f}" r="2.2" fill="#{:06x}"><title>{}</title></circle>)",
                   m_origin.x + place.x, m_origin.y + place.y, color, escaped(words));
    m_svg += '\n';
}

}  // namespace chiaro::metrics
