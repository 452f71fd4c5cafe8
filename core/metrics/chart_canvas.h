#pragma once

#include <glm/vec2.hpp>

#include <span>
#include <string>

/// What charts are drawn on: line_chart lays them out once, and a canvas makes a file of it.
namespace chiaro::metrics {

/// Where a text lies at its place; Upward ones are turned and centred.
enum class Anchor { Start, Middle, End, Upward };
enum class Lettering { Plain, Title };
/// A chart's lines by what they are: the grid behind it, its axes, a value's error, a curve.
enum class Stroke { Grid, Axis, Bar, Curve };

/// Lengths are px at normal size, x right, y down; colours 0xrrggbb.
class ChartCanvas {
public:
    virtual ~ChartCanvas() = default;
    /// What is drawn from now on lies relative to this place.
    virtual void moveTo(glm::dvec2 origin) = 0;
    /// Any UTF-8; `place` is on its base line.
    virtual void text(glm::dvec2 place, const std::string& text, Anchor anchor,
                      Lettering lettering = Lettering::Plain) = 0;
    /// From point to point. The colour only matters to bars and curves.
    virtual void line(std::span<const glm::dvec2> points, Stroke stroke, unsigned color = 0) = 0;
    /// A value on a curve, and what it says in words.
    virtual void dot(glm::dvec2 place, unsigned color, const std::string& words) = 0;
};

}  // namespace chiaro::metrics
