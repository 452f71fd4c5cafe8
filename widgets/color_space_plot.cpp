#include "widgets/color_space_plot.h"

#include "widgets/picture.h"

#include <QtWidgets>

#include <algorithm>
#include <cmath>

namespace chiaro::widgets {

namespace {

constexpr double standardAzimuth = 36;
constexpr double standardElevation = 22;
constexpr double degreesAPixel = 0.5;
constexpr double degreesAKey = 5;
constexpr double margin = 16;
constexpr std::size_t mostPoints = 2048;

/// At most so many of them, evenly spread, the first and the last included.
std::vector<glm::vec3> thinned(const std::vector<glm::vec3>& colors, std::size_t most) {
    if (colors.size() <= most) return colors;
    std::vector<glm::vec3> kept;
    for (std::size_t i = 0; i < most; ++i) kept.push_back(colors[i * (colors.size() - 1) / (most - 1)]);
    return kept;
}

glm::vec3 corner(int index) {
    return {float(index & 1), float(index >> 1 & 1), float(index >> 2 & 1)};
}

}  // namespace

ColorSpacePlot::ColorSpacePlot(QWidget* parent) : QWidget(parent) {
    setObjectName("color-space");
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Colours in RGB"));
    setToolTip(
        tr("The sample's colours in the RGB cube: dots are the strip's column averages, the line is its "
           "gradient.\nDrag or use the arrow keys to turn it; double-click or Home turns it back."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::OpenHandCursor);
    turnBack();
}

void ColorSpacePlot::setColors(const gradient::Gradient& averages, const gradient::Gradient& sorted) {
    m_averages = thinned(averages, mostPoints);
    m_sorted = thinned(sorted, mostPoints);
    update();
}

void ColorSpacePlot::setPath(const std::vector<glm::vec3>& colors, const std::vector<glm::vec3>& stops) {
    m_path = thinned(colors, mostPoints);
    m_stops = stops;
    update();
}

void ColorSpacePlot::turn(double azimuth, double elevation) {
    m_azimuth = std::remainder(azimuth, 360.0);
    m_elevation = std::clamp(elevation, -90.0, 90.0);
    update();
}

void ColorSpacePlot::turnBack() {
    turn(standardAzimuth, standardElevation);
}

glm::dvec3 ColorSpacePlot::seen(glm::vec3 color) const {
    const glm::dvec3 place = glm::dvec3(color) - 0.5;
    const double azimuth = glm::radians(m_azimuth), elevation = glm::radians(m_elevation);
    const double x = place.x * std::cos(azimuth) - place.z * std::sin(azimuth);
    const double towards = place.x * std::sin(azimuth) + place.z * std::cos(azimuth);
    return {x, place.y * std::cos(elevation) - towards * std::sin(elevation),
            place.y * std::sin(elevation) + towards * std::cos(elevation)};
}

QPointF ColorSpacePlot::toWidget(glm::vec3 color) const {
    // The cube's diagonal fits, however it is turned.
    const double edge = (std::min(width(), height()) - 2 * margin) / std::sqrt(3.0);
    const glm::dvec3 place = seen(color) * edge;
    return {width() / 2.0 + place.x, height() / 2.0 - place.y};
}

void ColorSpacePlot::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    m_dragging = true;
    m_last = event->position();
    setCursor(Qt::ClosedHandCursor);
}

void ColorSpacePlot::mouseMoveEvent(QMouseEvent* event) {
    if (!m_dragging) return;
    const QPointF by = (event->position() - m_last) * degreesAPixel;
    m_last = event->position();
    // What is held follows the pointer.
    turn(m_azimuth - by.x(), m_elevation + by.y());
}

void ColorSpacePlot::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    m_dragging = false;
    setCursor(Qt::OpenHandCursor);
}

void ColorSpacePlot::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) turnBack();
}

void ColorSpacePlot::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left:
            return turn(m_azimuth + degreesAKey, m_elevation);
        case Qt::Key_Right:
            return turn(m_azimuth - degreesAKey, m_elevation);
        case Qt::Key_Up:
            return turn(m_azimuth, m_elevation - degreesAKey);
        case Qt::Key_Down:
            return turn(m_azimuth, m_elevation + degreesAKey);
        case Qt::Key_Home:
            return turnBack();
        default:
            QWidget::keyPressEvent(event);
    }
}

void ColorSpacePlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.setRenderHint(QPainter::Antialiasing);
    paintCube(painter, true);
    paintPoints(painter);
    paintLine(painter, m_sorted, 2);
    if (!m_path.empty()) paintLine(painter, m_path, 3.6);
    paintStops(painter);
    paintCube(painter, false);
    paintLegend(painter);
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

void ColorSpacePlot::paintCube(QPainter& painter, bool behind) const {
    int farthest = 0;
    for (int i = 1; i < 8; ++i)
        if (seen(corner(i)).z < seen(corner(farthest)).z) farthest = i;
    const QColor plain = palette().color(QPalette::PlaceholderText);
    constexpr std::array axisColors{QColor(0xd0, 0x55, 0x4c), QColor(0x5f, 0xa8, 0x55),
                                    QColor(0x58, 0x86, 0xd6)};
    const std::array names{tr("R"), tr("G"), tr("B")};
    for (int from = 0; from < 8; ++from)
        for (int axis = 0; axis < 3; ++axis) {
            const int to = from | 1 << axis;
            const bool isBehind = from == farthest || to == farthest;
            if (to == from || isBehind != behind) continue;
            QColor color = from == 0 ? axisColors[std::size_t(axis)] : plain;
            color.setAlphaF(behind ? 0.45F : from == 0 ? 1.0F : 0.7F);
            painter.setPen(QPen(color, from == 0 ? 1.6 : 1));
            painter.drawLine(toWidget(corner(from)), toWidget(corner(to)));
        }
    if (behind) return;
    for (int axis = 0; axis < 3; ++axis) {
        const QPointF middle(width() / 2.0, height() / 2.0), end = toWidget(corner(1 << axis));
        const QLineF outwards(middle, end);
        const double reach = outwards.length() > 1 ? (outwards.length() + 9) / outwards.length() : 1;
        const QRectF place(outwards.pointAt(reach) - QPointF(8, 8), QSizeF(16, 16));
        painter.setPen(axisColors[std::size_t(axis)]);
        painter.drawText(place, Qt::AlignCenter, names[std::size_t(axis)]);
    }
}

void ColorSpacePlot::paintPoints(QPainter& painter) const {
    // The farthest first.
    std::vector<std::pair<double, glm::vec3>> points;
    for (const glm::vec3& color : m_averages) points.emplace_back(seen(color).z, color);
    std::ranges::stable_sort(points, {}, &std::pair<double, glm::vec3>::first);
    QColor outline = palette().color(QPalette::Text);
    outline.setAlphaF(0.35F);
    painter.setPen(QPen(outline, 0.6));
    for (const auto& [depth, color] : points) {
        painter.setBrush(toColor(color));
        painter.drawEllipse(toWidget(color), 2, 2);
    }
}

void ColorSpacePlot::paintLine(QPainter& painter, const std::vector<glm::vec3>& colors, double width) const {
    if (colors.size() < 2) return;
    QPolygonF line;
    for (const glm::vec3& color : colors) line << toWidget(color);
    // An edge that stands out from its own colours and from the ground.
    painter.setBrush(Qt::NoBrush);
    painter.setPen(
        QPen(palette().color(QPalette::Text), width + 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    for (int i = 0; i + 1 < line.size(); ++i) {
        const glm::vec3 color = (colors[std::size_t(i)] + colors[std::size_t(i) + 1]) / 2.0F;
        painter.setPen(QPen(toColor(color), width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(line[i], line[i + 1]);
    }
}

void ColorSpacePlot::paintStops(QPainter& painter) const {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.6));
    for (const glm::vec3& color : m_stops) {
        painter.setBrush(toColor(color));
        painter.drawRect(QRectF(toWidget(color) - QPointF(3.5, 3.5), QSizeF(7, 7)));
    }
}

void ColorSpacePlot::paintLegend(QPainter& painter) const {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const QRect area = rect().adjusted(8, 6, -8, -6);
    if (m_sorted.empty()) {
        painter.drawText(rect(), Qt::AlignCenter, tr("No strip"));
        return;
    }
    painter.drawText(area, Qt::AlignLeft | Qt::AlignTop,
                     m_path.empty() ? tr("· averages\n— gradient") : tr("· averages\n— gradient\n▪ in use"));
}

}  // namespace chiaro::widgets
