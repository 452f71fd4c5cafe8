#include "widgets/view_sphere.h"

#include <QtWidgets>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace chiaro::widgets {

namespace {

constexpr double degreesPerPixel = 0.6;
constexpr double step = 5;  // degrees, of an arrow key
constexpr double smallStep = 1;
constexpr double margin = 14;  // px around the sphere, for markers on its rim
constexpr int manyViews = 24;  // from here on markers are small and have no numbers
constexpr double degree = 3.14159265358979323846 / 180;

glm::dvec3 directionOf(double azimuth, double elevation) {
    return {std::sin(azimuth * degree) * std::cos(elevation * degree), std::sin(elevation * degree),
            std::cos(azimuth * degree) * std::cos(elevation * degree)};
}

double elevationOf(const glm::dvec3& direction) {
    return std::asin(std::clamp(glm::normalize(direction).y, -1.0, 1.0)) / degree;
}

double azimuthOf(const glm::dvec3& direction) {
    return std::atan2(direction.x, direction.z) / degree;
}

/// `first` with `share` of `second`, for what steps back in a dark palette and in a light one.
QColor mixed(const QColor& first, const QColor& second, double share) {
    const auto channel = [&](double a, double b) { return a + share * (b - a); };
    return QColor::fromRgbF(float(channel(first.redF(), second.redF())),
                            float(channel(first.greenF(), second.greenF())),
                            float(channel(first.blueF(), second.blueF())));
}

}  // namespace

ViewSphere::ViewSphere(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Views around the object"));
    describe();
}

void ViewSphere::setViews(std::vector<ViewMarker> views) {
    m_views = std::move(views);
    if (m_selected >= int(m_views.size())) m_selected = -1;
    describe();
    update();
}

void ViewSphere::setCameraDirection(const std::optional<glm::dvec3>& direction) {
    m_cameraDirection = direction;
    update();
}

void ViewSphere::setSelected(int view) {
    m_selected = view >= 0 && view < int(m_views.size()) ? view : -1;
    describe();
    update();
}

void ViewSphere::select(int view) {
    if (view == m_selected) return;
    setSelected(view);
    Q_EMIT selectionChanged(m_selected);
}

void ViewSphere::describe() {
    QString text = m_views.size() == 1 ? tr("1 view") : tr("%1 views").arg(m_views.size());
    if (m_selected >= 0) {
        const ViewMarker& view = m_views[std::size_t(m_selected)];
        text = (view.isPlaced ? tr("View %1 of %2, placed") : tr("View %1 of %2, planned"))
                   .arg(view.number)
                   .arg(m_views.size());
    }
    if (text == accessibleDescription()) return;
    setAccessibleDescription(text);
}

/// Columns: right, up, and towards the artist.
glm::dmat3 ViewSphere::basis() const {
    const glm::dvec3 towards = directionOf(m_azimuth, m_elevation);
    const glm::dvec3 right = directionOf(m_azimuth + 90, 0);
    return {right, glm::cross(towards, right), towards};
}

double ViewSphere::radius() const {
    return std::min(width(), height()) / 2.0 - margin;
}

double ViewSphere::markerRadius() const {
    return m_views.size() < manyViews ? 8.5 : 5;
}

QPointF ViewSphere::position(const glm::dvec3& direction) const {
    const glm::dvec3 seen = glm::transpose(basis()) * glm::normalize(direction);
    return center() + radius() * QPointF(seen.x, -seen.y);
}

bool ViewSphere::isNear(const glm::dvec3& direction) const {
    return glm::dot(directionOf(m_azimuth, m_elevation), direction) >= 0;
}

glm::dvec3 ViewSphere::directionAt(QPointF position, bool isNear) const {
    const QPointF at = (position - center()) / radius();
    glm::dvec3 seen(at.x(), -at.y(), 0);
    const double length = glm::length(seen);
    if (length >= 1)
        seen /= length;
    else
        seen.z = std::sqrt(1 - length * length) * (isNear ? 1 : -1);
    return basis() * seen;
}

/// The nearest marker under the pointer, those on the near side first; -1 for none.
int ViewSphere::viewAt(QPointF position) const {
    int found = -1;
    double best = markerRadius() + 3;
    bool isFoundNear = false;
    for (int view = 0; view < int(m_views.size()); ++view) {
        const glm::dvec3& direction = m_views[std::size_t(view)].direction;
        const QPointF away = this->position(direction) - position;
        const double distance = std::hypot(away.x(), away.y());
        const bool near = isNear(direction);
        if (distance > markerRadius() + 3 || (isFoundNear && !near)) continue;
        if (near == isFoundNear && distance >= best) continue;
        found = view;
        best = distance;
        isFoundNear = near;
    }
    return found;
}

void ViewSphere::turn(double azimuth, double elevation) {
    m_azimuth = std::remainder(m_azimuth + azimuth, 360);
    m_elevation = std::clamp(m_elevation + elevation, -90.0, 90.0);
    update();
}

void ViewSphere::face(const glm::dvec3& direction) {
    m_elevation = elevationOf(direction);
    if (std::abs(m_elevation) < 89.9) m_azimuth = azimuthOf(direction);
    update();
}

void ViewSphere::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    m_pressed = m_last = event->position();
    const int view = viewAt(event->position());
    m_grip = view >= 0 ? Grip::Pressed : Grip::Sphere;
    if (view < 0) return setCursor(Qt::ClosedHandCursor);
    select(view);
    const glm::dvec3& direction = m_views[std::size_t(view)].direction;
    m_wasNear = isNear(direction);
    m_offset = position(direction) - event->position();
}

void ViewSphere::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - m_pressed;
    if (m_grip == Grip::Pressed && std::abs(moved.x()) + std::abs(moved.y()) >= 3) m_grip = Grip::View;
    if (m_grip == Grip::View && m_selected >= 0)
        Q_EMIT viewMoved(m_selected, directionAt(event->position() + m_offset, m_wasNear));
    if (m_grip == Grip::Sphere) {
        const QPointF step = event->position() - m_last;
        turn(-step.x() * degreesPerPixel, step.y() * degreesPerPixel);
    }
    m_last = event->position();
}

void ViewSphere::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (m_grip == Grip::Sphere && event->position() == m_pressed) select(-1);
    const bool wasMoved = m_grip == Grip::View;
    m_grip = Grip::None;
    unsetCursor();
    if (wasMoved) Q_EMIT editFinished();
}

bool ViewSphere::focusNextPrevChild(bool next) {
    const int count = int(m_views.size());
    const int view = m_selected < 0 && !next ? count - 1 : m_selected + (next ? 1 : -1);
    if (view < 0 || view >= count) return QWidget::focusNextPrevChild(next);
    select(view);
    if (!isNear(m_views[std::size_t(view)].direction)) face(m_views[std::size_t(view)].direction);
    return true;
}

bool ViewSphere::nudge(QPoint step, Qt::KeyboardModifiers modifiers) {
    const double size = modifiers.testFlag(Qt::ShiftModifier) ? smallStep : widgets::step;
    if (m_selected < 0 || modifiers.testFlag(Qt::ControlModifier)) {
        turn(step.x() * size, step.y() * size);
        return true;
    }
    const glm::dvec3 direction = m_views[std::size_t(m_selected)].direction;
    const double elevation = std::clamp(elevationOf(direction) + step.y() * size, -89.0, 89.0);
    const glm::dvec3 moved = directionOf(azimuthOf(direction) + step.x() * size, elevation);
    m_nudged = true;
    Q_EMIT viewMoved(m_selected, moved);
    if (!isNear(moved)) face(moved);
    return true;
}

void ViewSphere::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left:
            nudge({-1, 0}, event->modifiers());
            return;
        case Qt::Key_Right:
            nudge({1, 0}, event->modifiers());
            return;
        case Qt::Key_Up:
            nudge({0, 1}, event->modifiers());
            return;
        case Qt::Key_Down:
            nudge({0, -1}, event->modifiers());
            return;
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            if (m_selected >= 0) Q_EMIT removeWanted(m_selected);
            return;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (m_selected >= 0) Q_EMIT lockWanted(m_selected);
            return;
        case Qt::Key_Escape:
            return select(-1);
        default:
            QWidget::keyPressEvent(event);
    }
}

void ViewSphere::keyReleaseEvent(QKeyEvent* event) {
    if (!event->isAutoRepeat()) finishNudge();
    QWidget::keyReleaseEvent(event);
}

void ViewSphere::focusOutEvent(QFocusEvent* event) {
    finishNudge();
    QWidget::focusOutEvent(event);
    update();
}

void ViewSphere::finishNudge() {
    if (std::exchange(m_nudged, false)) Q_EMIT editFinished();
}

bool ViewSphere::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        // Arrows and Delete are this widget's while it has the focus, whatever the menus say.
        const int key = static_cast<QKeyEvent*>(event)->key();
        if ((key >= Qt::Key_Left && key <= Qt::Key_Down) || key == Qt::Key_Delete || key == Qt::Key_Escape)
            event->accept();
    }
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int view = viewAt(QPointF(help->pos()));
        QToolTip::showText(help->globalPos(),
                           view >= 0 ? m_views[std::size_t(view)].tooltip
                                     : tr("Drag a view to move it, drag beside the views to turn the sphere"),
                           this);
        return true;
    }
    return QWidget::event(event);
}

void ViewSphere::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintSphere(painter);
    paintCamera(painter);
    // From far to near, the selected one last of its side.
    std::vector<int> order(m_views.size());
    std::iota(order.begin(), order.end(), 0);
    const glm::dvec3 towards = directionOf(m_azimuth, m_elevation);
    const auto rank = [&](int view) {
        const double depth = glm::dot(towards, glm::normalize(m_views[std::size_t(view)].direction));
        return view == m_selected ? (depth >= 0 ? 2 : -0.001) : depth;
    };
    std::ranges::sort(order, {}, rank);
    for (const int view : order) paintMarker(painter, view);
}

void ViewSphere::paintSphere(QPainter& painter) const {
    const double r = radius();
    QRadialGradient shade(center() - QPointF(0.35, 0.45) * r, r * 1.6);
    shade.setColorAt(0, palette().color(QPalette::Light));
    shade.setColorAt(1, palette().color(QPalette::Window).darker(125));
    painter.setPen(QPen(palette().color(QPalette::Dark), 1));
    painter.setBrush(shade);
    painter.drawEllipse(center(), r, r);
    const glm::dvec3 x(1, 0, 0);
    const glm::dvec3 y(0, 1, 0);
    const glm::dvec3 z(0, 0, 1);
    const double tilted = std::sqrt(0.5);
    paintCircle(painter, x, z, {0, 0, 0});
    paintCircle(painter, x * tilted, z * tilted, y * tilted);
    paintCircle(painter, x * tilted, z * tilted, -y * tilted);
    paintCircle(painter, x, y, {0, 0, 0});
    paintCircle(painter, z, y, {0, 0, 0});
    paintUp(painter);
    if (!hasFocus()) return;
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(center(), r + 1, r + 1);
}

/// The circle at + u cos + v sin: clear on the near side, faint on the far one.
void ViewSphere::paintCircle(QPainter& painter, const glm::dvec3& u, const glm::dvec3& v,
                             const glm::dvec3& at) const {
    constexpr int segments = 72;
    QPainterPath near;
    QPainterPath far;
    for (int i = 0; i < segments; ++i) {
        const auto point = [&](int k) {
            const double angle = 360.0 / segments * k * degree;
            return at + u * std::cos(angle) + v * std::sin(angle);
        };
        const glm::dvec3 begin = point(i);
        const glm::dvec3 end = point(i + 1);
        QPainterPath& path = isNear(begin + end) ? near : far;
        // One line as long as it goes on: ends that overlap would show as dots.
        if (path.currentPosition() != position(begin)) path.moveTo(position(begin));
        path.lineTo(position(end));
    }
    QColor color = palette().color(QPalette::Text);
    painter.setBrush(Qt::NoBrush);
    color.setAlpha(18);
    painter.setPen(QPen(color, 1));
    painter.drawPath(far);
    color.setAlpha(56);
    painter.setPen(QPen(color, 1));
    painter.drawPath(near);
}

/// The letters of the object's front and its up, so that the sphere can be read.
void ViewSphere::paintUp(QPainter& painter) const {
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.85);
    painter.setFont(small);
    const std::pair<glm::dvec3, QString> poles[] = {{{0, 1, 0}, tr("top")},
                                                    {{0, -1, 0}, tr("bottom")},
                                                    {{0, 0, 1}, tr("front")},
                                                    {{0, 0, -1}, tr("back")}};
    for (const auto& [direction, name] : poles) {
        if (!isNear(direction)) continue;
        QColor color = palette().color(QPalette::Text);
        color.setAlpha(130);
        painter.setPen(color);
        const QRectF box = QRectF(painter.fontMetrics().boundingRect(name)).adjusted(-2, -2, 2, 2);
        QRectF place(QPointF(0, 0), box.size());
        place.moveCenter(position(direction));
        painter.drawText(place, Qt::AlignCenter, name);
    }
}

void ViewSphere::paintMarker(QPainter& painter, int view) const {
    const ViewMarker& marker = m_views[std::size_t(view)];
    const QPointF at = position(marker.direction);
    const bool near = isNear(marker.direction);
    const bool isSelected = view == m_selected;
    const double r = markerRadius() * (near ? 1 : 0.8) * (marker.pass > 1 ? 0.82 : 1);
    const QColor accent = palette().color(QPalette::Highlight);
    QColor fill = marker.isPlaced ? accent : palette().color(QPalette::Text);
    if (marker.pass > 1) fill = mixed(fill, palette().color(QPalette::Window), 0.35);
    QColor edge = near ? palette().color(QPalette::Dark) : fill;
    if (!near) {
        edge.setAlpha(150);
        fill = palette().color(QPalette::Base);
        fill.setAlpha(170);
    }
    const auto shape = [&](double size) {
        if (marker.isPlaced)
            painter.drawRoundedRect(QRectF(at - QPointF(size, size), at + QPointF(size, size)), 2, 2);
        else
            painter.drawEllipse(at, size, size);
    };
    if (isSelected) {
        painter.setPen(QPen(palette().color(QPalette::Text), 2));
        painter.setBrush(Qt::NoBrush);
        shape(r + 3);
    }
    painter.setPen(QPen(edge, 1.2));
    painter.setBrush(fill);
    shape(r);
    if (m_views.size() >= manyViews) return;
    QFont small = font();
    small.setPixelSize(int(r * 1.25));
    small.setBold(near);
    painter.setFont(small);
    painter.setPen(near ? palette().color(marker.isPlaced ? QPalette::HighlightedText : QPalette::Base)
                        : edge);
    painter.drawText(QRectF(at - QPointF(r, r), at + QPointF(r, r)), Qt::AlignCenter,
                     QString::number(marker.number));
}

void ViewSphere::paintCamera(QPainter& painter) const {
    if (!m_cameraDirection) return;
    const QPointF at = position(*m_cameraDirection);
    QColor color = palette().color(QPalette::Text);
    color.setAlpha(isNear(*m_cameraDirection) ? 200 : 70);
    painter.setPen(QPen(color, 1.4));
    constexpr double inner = 4;
    constexpr double outer = 15;
    for (const QPointF& arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
        painter.drawLine(at + arm * inner, at + arm * outer);
}

}  // namespace chiaro::widgets
