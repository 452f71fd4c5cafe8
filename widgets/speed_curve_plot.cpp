#include "widgets/speed_curve_plot.h"

#include "widgets/picture.h"

#include <QtWidgets>

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr double margin = 8;
constexpr double barHeight = 12;        ///< of the averages and of the followed gradient
constexpr double reach = 10;            ///< px from a point that still take hold of it
constexpr float smallestStep = 0.002F;  ///< between the x of neighbours: they must rise
constexpr float nudge = 0.005F;

}  // namespace

SpeedCurvePlot::SpeedCurvePlot(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Speed curve"));
    setToolTip(
        tr("How fast the gradient's colours pass along the strip.\n"
           "Drag a point; double-click adds one, Delete removes it.\n"
           "Page Up and Page Down select a point, the arrow keys nudge it (Shift: more).\n"
           "Below: the strip's column averages, and the gradient that should follow them."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void SpeedCurvePlot::setCurve(const gradient::SpeedCurve& curve) {
    m_curve = curve;
    if (m_selected >= int(curve.points.size())) select(-1);
    update();
}

void SpeedCurvePlot::setColors(const gradient::Gradient& averages, const gradient::Gradient& sorted) {
    m_sorted = sorted;
    m_averagesBar = toImage(averages);
    m_sortedBar = toImage(sorted).transformed(QTransform().rotate(-90));
    update();
}

void SpeedCurvePlot::select(int point) {
    if (point == m_selected) return;
    m_selected = point;
    update();
    Q_EMIT selectionChanged(point);
}

glm::vec2 SpeedCurvePlot::selectedPlace() const {
    return m_selected >= 0 ? m_curve.points[std::size_t(m_selected)] : glm::vec2(0);
}

QRectF SpeedCurvePlot::plotArea() const {
    return QRectF(rect()).adjusted(margin, margin, -margin, -(margin + 2 * barHeight + 6));
}

QPointF SpeedCurvePlot::toWidget(glm::vec2 place) const {
    const QRectF area = plotArea();
    return {area.left() + double(place.x) * area.width(), area.bottom() - double(place.y) * area.height()};
}

glm::vec2 SpeedCurvePlot::toPlace(QPointF position) const {
    const QRectF area = plotArea();
    if (area.isEmpty()) return {0, 0};
    return {float((position.x() - area.left()) / area.width()),
            float((area.bottom() - position.y()) / area.height())};
}

int SpeedCurvePlot::pointAt(QPointF position) const {
    int nearest = -1;
    double distance = reach;
    for (int i = 0; i < int(m_curve.points.size()); ++i) {
        const double away = QLineF(position, toWidget(m_curve.points[std::size_t(i)])).length();
        if (away <= distance) {
            nearest = i;
            distance = away;
        }
    }
    return nearest;
}

bool SpeedCurvePlot::isEnd(int point) const {
    return point == 0 || point + 1 == int(m_curve.points.size());
}

void SpeedCurvePlot::moveSelected(glm::vec2 place) {
    if (m_selected < 0 || isEnd(m_selected)) return;
    gradient::SpeedCurve curve = m_curve;
    const auto point = std::size_t(m_selected);
    const glm::vec2 before = curve.points[point - 1];
    const glm::vec2 after = curve.points[point + 1];
    // Points may stand closer than the step when they were matched; then x stays.
    const float low = before.x + smallestStep;
    const float high = after.x - smallestStep;
    if (low < high) curve.points[point].x = std::clamp(place.x, low, high);
    curve.points[point].y = std::clamp(place.y, before.y, after.y);
    edit(curve);
}

void SpeedCurvePlot::removeSelected() {
    if (m_selected < 0 || isEnd(m_selected)) return;
    gradient::SpeedCurve curve = m_curve;
    curve.points.erase(curve.points.begin() + m_selected);
    select(-1);
    edit(curve);
    Q_EMIT editFinished();
}

void SpeedCurvePlot::add(glm::vec2 place) {
    gradient::SpeedCurve curve = m_curve;
    const auto after = std::find_if(curve.points.begin(), curve.points.end(),
                                    [&](glm::vec2 point) { return point.x > place.x; });
    if (after == curve.points.begin() || after == curve.points.end()) return;
    const auto before = after - 1;
    if (place.x - before->x < smallestStep || after->x - place.x < smallestStep) return;
    place.y = std::clamp(place.y, before->y, after->y);
    const int index = int(after - curve.points.begin());
    curve.points.insert(after, place);
    edit(curve);
    select(index);
}

void SpeedCurvePlot::edit(const gradient::SpeedCurve& curve) {
    if (curve == m_curve) return;
    m_curve = curve;
    update();
    Q_EMIT curveEdited(curve);
}

void SpeedCurvePlot::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_sorted.empty()) return;
    select(pointAt(event->position()));
    if (m_selected < 0) return;
    m_pressedCurve = m_curve;
    m_dragging = true;
    m_grip = toWidget(m_curve.points[std::size_t(m_selected)]) - event->position();
}

void SpeedCurvePlot::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragging) moveSelected(toPlace(event->position() + m_grip));
}

void SpeedCurvePlot::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_dragging) return;
    m_dragging = false;
    Q_EMIT editFinished();
}

void SpeedCurvePlot::mouseDoubleClickEvent(QMouseEvent* event) {
    // A second quick press on a point takes hold of it again.
    if (event->button() != Qt::LeftButton || m_sorted.empty() || pointAt(event->position()) >= 0)
        return mousePressEvent(event);
    m_pressedCurve = m_curve;
    add(toPlace(event->position()));
    m_dragging = m_selected >= 0;
    m_grip = {};
}

void SpeedCurvePlot::keyPressEvent(QKeyEvent* event) {
    const int last = int(m_curve.points.size()) - 1;
    const float step = event->modifiers() & Qt::ShiftModifier ? 10 * nudge : nudge;
    glm::vec2 by(0);
    switch (event->key()) {
        case Qt::Key_Escape:
            if (!m_dragging) return QWidget::keyPressEvent(event);
            m_dragging = false;
            if (m_curve.points.size() != m_pressedCurve.points.size()) select(-1);
            edit(m_pressedCurve);
            Q_EMIT editFinished();
            return;
        case Qt::Key_PageDown:
            return select(std::min(m_selected + 1, last));
        case Qt::Key_PageUp:
            return select(std::max(m_selected - 1, 0));
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            return removeSelected();
        case Qt::Key_Insert: {
            // Halfway to the next point, where a double click can't be made.
            const auto from = std::size_t(std::clamp(m_selected, 0, last - 1));
            add((m_curve.points[from] + m_curve.points[from + 1]) / 2.0F);
            Q_EMIT editFinished();
            return;
        }
        case Qt::Key_Left:
            by.x = -step;
            break;
        case Qt::Key_Right:
            by.x = step;
            break;
        case Qt::Key_Up:
            by.y = step;
            break;
        case Qt::Key_Down:
            by.y = -step;
            break;
        default:
            return QWidget::keyPressEvent(event);
    }
    if (m_selected < 0) return;
    m_nudged = true;
    moveSelected(m_curve.points[std::size_t(m_selected)] + by);
}

void SpeedCurvePlot::keyReleaseEvent(QKeyEvent* event) {
    if (!event->isAutoRepeat()) finishNudge();
    QWidget::keyReleaseEvent(event);
}

void SpeedCurvePlot::focusOutEvent(QFocusEvent* event) {
    finishNudge();
    QWidget::focusOutEvent(event);
}

void SpeedCurvePlot::finishNudge() {
    if (!m_nudged) return;
    m_nudged = false;
    Q_EMIT editFinished();
}

void SpeedCurvePlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (m_sorted.empty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect(), Qt::AlignCenter, tr("No strip"));
        return;
    }
    paintColors(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    paintCurve(painter);
}

void SpeedCurvePlot::paintColors(QPainter& painter) const {
    const QRectF area = plotArea();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(area, m_sortedBar);
    painter.setPen(QColor(0, 0, 0, 50));
    for (int i = 1; i < 4; ++i) {
        const float quarter = float(i) / 4;
        painter.drawLine(toWidget({quarter, 0}), toWidget({quarter, 1}));
        painter.drawLine(toWidget({0, quarter}), toWidget({1, quarter}));
    }
    const QRectF averages(area.left(), area.bottom() + 6, area.width(), barHeight);
    painter.drawImage(averages, m_averagesBar);
    painter.drawImage(averages.translated(0, barHeight), followed());
}

QImage SpeedCurvePlot::followed() const {
    const std::vector<double> speed = m_curve.sampled(int(m_sorted.size()));
    gradient::Gradient colors;
    for (double u : speed) colors.push_back(gradient::lookUp(m_sorted, float(u)));
    return toImage(colors);
}

void SpeedCurvePlot::paintCurve(QPainter& painter) const {
    const int steps = std::max(2, int(plotArea().width()));
    const std::vector<double> speed = m_curve.sampled(steps);
    QPolygonF line;
    for (int i = 0; i < steps; ++i)
        line << toWidget({float(i) / float(steps - 1), float(speed[std::size_t(i)])});
    painter.setPen(QPen(QColor(0, 0, 0, 150), 3.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setPen(QPen(Qt::white, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);

    for (int i = 0; i < int(m_curve.points.size()); ++i) {
        const bool selected = i == m_selected;
        painter.setPen(QPen(QColor(0, 0, 0, 190), 1.2));
        painter.setBrush(selected ? palette().color(QPalette::Highlight) : QColor(Qt::white));
        const double radius = selected ? 5.5 : isEnd(i) ? 3.2 : 4.2;
        painter.drawEllipse(toWidget(m_curve.points[std::size_t(i)]), radius, radius);
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(plotArea());
    }
}

}  // namespace chiaro::widgets
