#pragma once

#include <glm/vec2.hpp>

#include <QImage>
#include <QPolygonF>
#include <QRect>

#include <span>
#include <string>
#include <vector>

namespace chiaro::widgets {

/// Which methods a viewport shows of its one scene, camera and light, and how their pictures lie together.
struct Composition {
    enum class Mode {
        Single,      ///< one method, as if nothing were compared
        SideBySide,  ///< all of them in panes of their own
        Wipe,        ///< the first on one side of a line, the second on the other
        Blend,       ///< the second laid over the first
        Difference   ///< how far they are apart, channel by channel; equal pixels are black
    };
    Mode mode = Mode::Single;
    std::vector<std::string> methods = {};  ///< side by side up to three, else the first two count
    glm::dvec2 wipeCenter{0.5};  ///< a point of the line, shares of the picture's width and height, y down
    double wipeAngle = 0;        ///< degrees, clockwise, (-180, 180]; at 0 the second is right of the line
    double blend = 0.5;          ///< the second's share, [0, 1]
    double gain = 4;             ///< that differences are multiplied with, 1..64

    friend bool operator==(const Composition&, const Composition&) = default;

    static constexpr double largestGain = 64;
    static constexpr std::size_t mostPanes = 3;
    /// How many methods are seen: 1 in Single or without two methods.
    std::size_t shownCount() const;
};

/// A line across a picture: a point p shows the second method where dot(p, normal) > offset.
struct WipeLine {
    glm::dvec2 normal{1, 0};  ///< unit
    double offset = 0;

    bool isSecond(glm::dvec2 point) const { return point.x * normal.x + point.y * normal.y > offset; }
};
/// In a picture of this size, y down.
WipeLine wipeLine(const Composition& composition, QSizeF size);
/// How far the line has come from where the second fills the picture, 0, to where the first does, 1.
double wipePosition(const Composition& composition, QSizeF size);
/// With the line there, as upright as before; its centre is in the picture.
Composition wipedTo(const Composition& composition, QSizeF size, double position);
/// The part of a picture of this size that shows the second method, or the first.
QPolygonF wipeSide(const Composition& composition, QSizeF size, bool second);

/// Where the picture of each shown method lies in a viewport of this size; all are equally large. Panes lie
/// in a row, or below each other where the viewport is higher than wide, with a gap of two pixels a `ratio`
/// of 1.
std::vector<QRect> paneRects(const Composition& composition, QSize size, double ratio = 1);

/// Where the picture of a shown method lies in a widget.
struct Pane {
    QRectF rect;     ///< of the whole picture
    QPolygonF seen;  ///< the part of the widget where this method is seen by itself; in a blend and in a
                     ///< difference all of it belongs to the first
    friend bool operator==(const Pane&, const Pane&) = default;
};
/// In a widget of this size whose device pixels are `ratio` to a pixel, one a shown method.
std::vector<Pane> panesOf(const Composition& composition, QSize size, double ratio);

/// The pictures of the shown methods, which are equally large, as one: side by side of this size, with gaps
/// of the colour of `ground`; else as large as they are.
QImage composed(const Composition& composition, std::span<const QImage> pictures, QSize size, double ratio,
                QColor ground);

}  // namespace chiaro::widgets
