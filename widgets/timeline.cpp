#include "widgets/timeline.h"

#include <QtWidgets>

#include <algorithm>
#include <cmath>

namespace chiaro::widgets {

namespace {

constexpr int rulerHeight = 24;
constexpr int laneHeight = 20;
constexpr int margin = 12;     ///< on both sides of the frames
constexpr int nameWidth = 58;  ///< of the lanes' names
constexpr double keyRadius = 5;
constexpr double reach = 7;  ///< within which the mouse takes hold

/// 1, 2 or 5 times a power of ten: the least that leaves a label this many pixels.
int labelStep(double pixelsPerFrame, double labelWidth) {
    for (int power = 1; power < 1'000'000; power *= 10)
        for (const int step : {1, 2, 5})
            if (step * power * pixelsPerFrame >= labelWidth) return step * power;
    return 1'000'000;
}

QPolygonF diamond(QPointF at, double radius) {
    return {{at + QPointF(0, -radius), at + QPointF(radius, 0), at + QPointF(0, radius),
             at + QPointF(-radius, 0)}};
}

}  // namespace

Timeline::Timeline(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Timeline"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize Timeline::sizeHint() const {
    return {600, rulerHeight + int(m_lanes.size()) * laneHeight + 2};
}

QSize Timeline::minimumSizeHint() const {
    return {240, sizeHint().height()};
}

void Timeline::setFrames(int frames, int first, int last) {
    m_frames = std::max(frames, 1);
    m_first = first;
    m_last = last;
    update();
}

void Timeline::setLanes(std::vector<Lane> lanes) {
    const bool resized = lanes.size() != m_lanes.size();
    m_lanes = std::move(lanes);
    if (m_selected) {
        const bool isThere =
            m_selected->lane < int(m_lanes.size()) &&
            std::ranges::binary_search(m_lanes[std::size_t(m_selected->lane)].keys, m_selected->frame);
        if (!isThere) select(std::nullopt);
    }
    if (resized) updateGeometry();
    update();
}

void Timeline::setCurrentFrame(int frame) {
    m_current = frame;
    update();
}

double Timeline::left() const {
    return nameWidth + margin;
}

double Timeline::right() const {
    return std::max(width() - double(margin) - 4, left() + 1);
}

double Timeline::positionOf(int frame) const {
    return left() + (right() - left()) * double(frame - 1) / std::max(1, m_frames - 1);
}

QPointF Timeline::positionOf(const Key& key) const {
    return {positionOf(key.frame), rulerHeight + (key.lane + 0.5) * laneHeight};
}

int Timeline::frameAt(double x) const {
    const double share = (x - left()) / (right() - left());
    return std::clamp(1 + int(std::lround(share * (m_frames - 1))), 1, m_frames);
}

std::optional<Timeline::Key> Timeline::keyAt(QPointF position) const {
    std::optional<Key> nearest;
    double best = reach;
    for (int lane = 0; lane < int(m_lanes.size()); ++lane)
        for (const int frame : m_lanes[std::size_t(lane)].keys) {
            const QPointF way = positionOf(Key{lane, frame}) - position;
            const double distance = std::hypot(way.x(), way.y());
            if (distance >= best) continue;
            best = distance;
            nearest = Key{lane, frame};
        }
    return nearest;
}

Timeline::Drag Timeline::rangeEndAt(QPointF position) const {
    if (position.y() > rulerHeight || position.y() < rulerHeight - 9) return Drag::None;
    const double first = std::abs(position.x() - positionOf(m_first) + 3);
    const double last = std::abs(position.x() - positionOf(m_last) - 3);
    if (std::min(first, last) > reach) return Drag::None;
    return first < last ? Drag::First : Drag::Last;
}

std::optional<int> Timeline::keyBefore() const {
    std::optional<int> found;
    for (const Lane& lane : m_lanes)
        for (const int frame : lane.keys)
            if (frame < m_current) found = std::max(found.value_or(frame), frame);
    return found;
}

std::optional<int> Timeline::keyAfter() const {
    std::optional<int> found;
    for (const Lane& lane : m_lanes)
        for (const int frame : lane.keys)
            if (frame > m_current) found = std::min(found.value_or(frame), frame);
    return found;
}

void Timeline::select(std::optional<Key> key) {
    if (key == m_selected) return;
    m_selected = key;
    update();
    Q_EMIT selectionChanged();
}

void Timeline::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    paintRuler(painter);
    paintLanes(painter);
    const double x = std::round(positionOf(m_current)) + 0.5;
    const QColor accent = palette().color(QPalette::Highlight);
    painter.setPen(QPen(accent, 1.4));
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    const QString number = QString::number(m_current);
    const double half = fontMetrics().horizontalAdvance(number) / 2.0 + 5;
    const double middle = std::clamp(x, half, width() - half);
    const QRectF flag(middle - half, 1, 2 * half, rulerHeight - 10);
    painter.setPen(Qt::NoPen);
    painter.setBrush(accent);
    painter.drawRoundedRect(flag, 2, 2);
    painter.setPen(palette().color(QPalette::HighlightedText));
    painter.drawText(flag, Qt::AlignCenter, number);
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(accent.darker(150), 1));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

void Timeline::paintRuler(QPainter& painter) const {
    painter.fillRect(QRectF(0, 0, width(), rulerHeight), palette().color(QPalette::Window).darker(112));
    const double perFrame = (right() - left()) / std::max(1, m_frames - 1);
    const int step = labelStep(perFrame, 44);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    for (int frame = 1; frame <= m_frames; frame = frame == 1 && step > 1 ? step : frame + step) {
        const double x = positionOf(frame);
        painter.drawLine(QPointF(x, rulerHeight - 8), QPointF(x, rulerHeight - 4));
        painter.drawText(QRectF(x - 24, 1, 48, rulerHeight - 10), Qt::AlignCenter, QString::number(frame));
    }
    const QColor range = palette().color(QPalette::Highlight).darker(140);
    const QRectF bar(positionOf(m_first), rulerHeight - 4, positionOf(m_last) - positionOf(m_first), 3);
    painter.fillRect(bar, range);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Highlight));
    painter.drawRect(QRectF(bar.left() - 4, rulerHeight - 8, 4, 7));
    painter.drawRect(QRectF(bar.right(), rulerHeight - 8, 4, 7));
}

void Timeline::paintLanes(QPainter& painter) const {
    for (int lane = 0; lane < int(m_lanes.size()); ++lane) {
        const QRectF row(0, rulerHeight + lane * laneHeight, width(), laneHeight);
        if (lane % 2 == 1) painter.fillRect(row, palette().color(QPalette::AlternateBase));
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(row.adjusted(8, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft,
                         m_lanes[std::size_t(lane)].name);
        for (const int frame : m_lanes[std::size_t(lane)].keys) {
            const Key key{lane, frame};
            const bool isSelected = m_selected == key;
            painter.setPen(QPen(palette().color(QPalette::Dark), 1));
            painter.setBrush(palette().color(isSelected ? QPalette::Highlight : QPalette::Text));
            painter.drawPolygon(diamond(positionOf(key), keyRadius + (isSelected ? 1 : 0)));
        }
    }
}

void Timeline::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_drag != Drag::None) return;
    if (const auto key = keyAt(event->position())) {
        select(key);
        m_drag = Drag::Key;
        return;
    }
    m_drag = rangeEndAt(event->position());
    if (m_drag != Drag::None) return;
    select(std::nullopt);
    m_drag = Drag::Frame;
    dragTo(event->position().x());
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
    if (m_drag != Drag::None) return dragTo(event->position().x());
    const bool isHandle = rangeEndAt(event->position()) != Drag::None || keyAt(event->position());
    setCursor(isHandle ? Qt::SizeHorCursor : Qt::ArrowCursor);
}

void Timeline::dragTo(double x) {
    const int frame = frameAt(x);
    switch (m_drag) {
        case Drag::None:
            return;
        case Drag::Frame:
            if (frame != m_current) Q_EMIT currentFrameEdited(frame);
            return;
        case Drag::Key: {
            if (!m_selected) return;  // it was removed meanwhile
            // A key never lands on another: that would be gone for good amid a drag.
            const auto& keys = m_lanes[std::size_t(m_selected->lane)].keys;
            if (std::ranges::binary_search(keys, frame)) return;
            const Key from = *m_selected;
            m_selected = Key{from.lane, frame};
            Q_EMIT keyMoved(from.lane, from.frame, frame);
            return;
        }
        case Drag::First:
            if (const int first = std::min(frame, m_last); first != m_first)
                Q_EMIT rangeEdited(first, m_last);
            return;
        case Drag::Last:
            if (const int last = std::max(frame, m_first); last != m_last) Q_EMIT rangeEdited(m_first, last);
            return;
    }
}

void Timeline::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_drag == Drag::None) return;
    if (std::exchange(m_drag, Drag::None) != Drag::Frame) Q_EMIT editFinished();
}

void Timeline::keyPressEvent(QKeyEvent* event) {
    const int step = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    const auto go = [this](std::optional<int> frame) {
        if (frame) Q_EMIT currentFrameEdited(std::clamp(*frame, 1, m_frames));
    };
    switch (event->key()) {
        case Qt::Key_Left:
            return go(m_current - step);
        case Qt::Key_Right:
            return go(m_current + step);
        case Qt::Key_Home:
            return go(1);
        case Qt::Key_End:
            return go(m_frames);
        case Qt::Key_Up:
            return go(keyAfter());
        case Qt::Key_Down:
            return go(keyBefore());
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            if (m_selected) Q_EMIT keyRemoveWanted(m_selected->lane, m_selected->frame);
            return;
        default:
            QWidget::keyPressEvent(event);
    }
}

void Timeline::wheelEvent(QWheelEvent* event) {
    if (event->angleDelta().y() == 0) return;
    const int frame = std::clamp(m_current + (event->angleDelta().y() > 0 ? -1 : 1), 1, m_frames);
    if (frame != m_current) Q_EMIT currentFrameEdited(frame);
    event->accept();
}

bool Timeline::event(QEvent* event) {
    // Home is the first frame here, whatever it is a shortcut of elsewhere.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Home) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ToolTip) {
        const QPointF position = static_cast<QHelpEvent*>(event)->pos();
        if (const auto key = keyAt(position))
            setToolTip(tr("%1 key at frame %2; drag to move it, Delete removes it")
                           .arg(m_lanes[std::size_t(key->lane)].name)
                           .arg(key->frame));
        else if (rangeEndAt(position) != Drag::None)
            setToolTip(tr("Frames %1 to %2 are rendered; drag an end").arg(m_first).arg(m_last));
        else
            setToolTip(tr("Frame %1; drag to go through the frames").arg(frameAt(position.x())));
    }
    return QWidget::event(event);
}

}  // namespace chiaro::widgets
