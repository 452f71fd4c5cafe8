#include "widgets/color_path_bar.h"

#include "widgets/picture.h"

#include <QtWidgets>

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr double margin = 8;
constexpr double barHeight = 34;
constexpr double handleWidth = 12;
constexpr double handleHeight = 16;
constexpr float nudge = 0.005F;

}  // namespace

ColorPathBar::ColorPathBar(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Colour stops"));
    setToolTip(
        tr("Ctrl+click adds a stop, a drag moves it, a double click changes its colour, Delete removes it.\n"
           "Page Up and Page Down select a stop, Left and Right nudge it (Shift: more), Enter changes its "
           "colour, Insert adds one.\n"
           "Ctrl+C and Ctrl+V copy and paste the stops as text, such as 0 #201040, 1 #fff0b0."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ColorPathBar::setPath(const gradient::ColorPath& path) {
    m_path = path;
    if (m_selected >= int(path.stops.size())) select(int(path.stops.size()) - 1);
    update();
}

void ColorPathBar::setOwnColors(const std::vector<glm::vec3>& colors) {
    m_ownColors = colors;
    update();
}

void ColorPathBar::select(int stop) {
    if (stop == m_selected) return;
    m_selected = stop;
    update();
    Q_EMIT selectionChanged(stop);
}

void ColorPathBar::moveSelected(float position) {
    if (m_selected < 0) return;
    gradient::ColorPath path = m_path;
    gradient::ColorStop stop = path.stops[std::size_t(m_selected)];
    stop.position = std::clamp(position, 0.0F, 1.0F);
    if (stop == path.stops[std::size_t(m_selected)]) return;
    path.stops.erase(path.stops.begin() + m_selected);
    insert(std::move(path), stop);
}

void ColorPathBar::recolorSelected(glm::vec3 color) {
    if (m_selected < 0) return;
    gradient::ColorPath path = m_path;
    path.stops[std::size_t(m_selected)].color = color;
    edit(path);
}

void ColorPathBar::removeSelected() {
    if (m_selected < 0 || m_path.stops.size() < 2) return;
    gradient::ColorPath path = m_path;
    path.stops.erase(path.stops.begin() + m_selected);
    const int next = std::min(m_selected, int(path.stops.size()) - 1);
    edit(path);
    m_selected = -1;
    select(next);
    Q_EMIT editFinished();
}

void ColorPathBar::add(float position) {
    if (m_path.stops.empty()) return;
    position = std::clamp(position, 0.0F, 1.0F);
    insert(m_path, {position, m_path.at(position)});
}

void ColorPathBar::addBesideSelected() {
    if (m_path.stops.empty()) return;
    const int last = int(m_path.stops.size()) - 1;
    const int from = std::clamp(m_selected, 0, std::max(0, last - 1));
    const float left = m_path.stops[std::size_t(from)].position;
    const float right = last > 0 ? m_path.stops[std::size_t(from) + 1].position : (left < 0.5F ? 1.0F : 0.0F);
    add((left + right) / 2);
    Q_EMIT editFinished();
}

void ColorPathBar::insert(gradient::ColorPath path, gradient::ColorStop stop) {
    const auto place =
        std::find_if(path.stops.begin(), path.stops.end(),
                     [&](const gradient::ColorStop& other) { return other.position > stop.position; });
    const int index = int(place - path.stops.begin());
    path.stops.insert(place, stop);
    edit(path);
    select(index);
}

void ColorPathBar::edit(const gradient::ColorPath& path) {
    if (path == m_path) return;
    m_path = path;
    update();
    Q_EMIT pathEdited(path);
}

QRectF ColorPathBar::barArea() const {
    return {margin, 1, width() - 2 * margin, barHeight};
}

double ColorPathBar::toWidget(float position) const {
    return barArea().left() + double(position) * barArea().width();
}

float ColorPathBar::toPosition(double x) const {
    return barArea().width() > 0 ? float((x - barArea().left()) / barArea().width()) : 0;
}

QPointF ColorPathBar::handle(int stop) const {
    return {toWidget(m_path.stops[std::size_t(stop)].position), barArea().bottom() + handleHeight / 2 + 4};
}

int ColorPathBar::stopAt(QPointF position) const {
    int nearest = -1;
    double distance = handleWidth / 2 + 3;
    // The selected one lies on top.
    const auto consider = [&](int stop) {
        const double away = std::abs(handle(stop).x() - position.x());
        if (away < distance) {
            nearest = stop;
            distance = away;
        }
    };
    if (m_selected >= 0) consider(m_selected);
    for (int stop = 0; stop < int(m_path.stops.size()); ++stop) consider(stop);
    return nearest;
}

void ColorPathBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_path.stops.empty()) return;
    m_pressedPath = m_path;
    m_pressedStop = m_selected;
    if (event->modifiers() & Qt::ControlModifier) {
        add(toPosition(event->position().x()));
    } else {
        const int stop = stopAt(event->position());
        if (stop < 0) return;
        select(stop);
    }
    m_dragging = true;
    m_grip = handle(m_selected).x() - event->position().x();
}

void ColorPathBar::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragging) moveSelected(toPosition(event->position().x() + m_grip));
}

void ColorPathBar::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_dragging) return;
    m_dragging = false;
    Q_EMIT editFinished();
}

void ColorPathBar::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || (event->modifiers() & Qt::ControlModifier)) return;
    const int stop = stopAt(event->position());
    if (stop < 0) return;
    select(stop);
    Q_EMIT colorWanted(stop);
}

bool ColorPathBar::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        // Whatever else these keys are shortcuts of.
        auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Copy) || key->matches(QKeySequence::Paste)) event->accept();
    }
    return QWidget::event(event);
}

void ColorPathBar::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy)) return Q_EMIT copyWanted();
    if (event->matches(QKeySequence::Paste)) return Q_EMIT pasteWanted();
    const int last = int(m_path.stops.size()) - 1;
    const float step = event->modifiers() & Qt::ShiftModifier ? 10 * nudge : nudge;
    switch (event->key()) {
        case Qt::Key_Escape:
            if (!m_dragging) return QWidget::keyPressEvent(event);
            m_dragging = false;
            edit(m_pressedPath);
            select(m_pressedStop);
            Q_EMIT editFinished();
            return;
        case Qt::Key_PageDown:
            return select(std::min(m_selected + 1, last));
        case Qt::Key_PageUp:
            return select(std::max(m_selected - 1, std::min(0, last)));
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            return removeSelected();
        case Qt::Key_Insert:
            return addBesideSelected();
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (m_selected >= 0) Q_EMIT colorWanted(m_selected);
            return;
        case Qt::Key_Left:
        case Qt::Key_Right:
            if (m_selected < 0) return;
            m_nudged = true;
            return moveSelected(m_path.stops[std::size_t(m_selected)].position +
                                (event->key() == Qt::Key_Right ? step : -step));
        default:
            QWidget::keyPressEvent(event);
    }
}

void ColorPathBar::keyReleaseEvent(QKeyEvent* event) {
    if (!event->isAutoRepeat()) finishNudge();
    QWidget::keyReleaseEvent(event);
}

void ColorPathBar::focusOutEvent(QFocusEvent* event) {
    finishNudge();
    QWidget::focusOutEvent(event);
}

void ColorPathBar::finishNudge() {
    if (!m_nudged) return;
    m_nudged = false;
    Q_EMIT editFinished();
}

void ColorPathBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF bar = barArea();
    const std::vector<glm::vec3> colors =
        isEnabled() && !m_path.stops.empty()
            ? m_path.sampled(std::max(2, int(bar.width() * devicePixelRatioF())))
            : m_ownColors;
    if (colors.empty())
        painter.fillRect(bar, palette().color(QPalette::Base));
    else
        painter.drawImage(bar, toImage(colors));
    if (!isEnabled()) return;
    for (int stop = 0; stop < int(m_path.stops.size()); ++stop)
        if (stop != m_selected) paintHandle(painter, stop);
    if (m_selected >= 0) paintHandle(painter, m_selected);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(bar);
    }
}

void ColorPathBar::paintHandle(QPainter& painter, int stop) const {
    const QPointF center = handle(stop);
    const double half = handleWidth / 2;
    const double top = center.y() - handleHeight / 2;
    QPainterPath house(QPointF(center.x(), top - 4));
    house.lineTo(center.x() + half, top + 3);
    house.lineTo(center.x() + half, top + handleHeight);
    house.lineTo(center.x() - half, top + handleHeight);
    house.lineTo(center.x() - half, top + 3);
    house.closeSubpath();
    const bool selected = stop == m_selected;
    painter.setPen(QPen(selected ? palette().color(QPalette::Highlight) : palette().color(QPalette::Text),
                        selected ? 2 : 1.2));
    painter.setBrush(toColor(m_path.stops[std::size_t(stop)].color));
    painter.drawPath(house);
}

}  // namespace chiaro::widgets
