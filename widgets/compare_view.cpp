#include "widgets/compare_view.h"

#include "widgets/viewport/viewport.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <QtWidgets>

namespace chiaro::widgets {

namespace {

using Mode = Composition::Mode;

constexpr int margin = 12;
constexpr int sphereRoom = 88;  ///< in the top right corner, for the light
constexpr int noteRoom = 40;    ///< at the bottom left, for the viewport's note
constexpr double reach = 7;     ///< pixels around the line where it is taken
constexpr double handleReach = 11;
constexpr double shareOfArm = 0.3;  ///< of the smaller side, from the middle to a handle that turns
constexpr double turnStep = 15;
constexpr double keyMove = 0.02;
constexpr double keyTurn = 5;

glm::dvec2 vectorOf(QPointF point) {
    return {point.x(), point.y()};
}

QPointF pointOf(glm::dvec2 vector) {
    return {vector.x, vector.y};
}

double wrapped(double degrees) {
    const double turned = std::fmod(degrees, 360);
    return turned > 180 ? turned - 360 : turned <= -180 ? turned + 360 : turned;
}

}  // namespace

CompareView::CompareView(Viewport& viewport, const std::vector<NamedMethod>& methods) : m_viewport(viewport) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setAccessibleName(tr("Wipe line"));
    viewport.addOverlay(this);
    viewport.installEventFilter(this);
    const std::vector<QString> names{tr("First picture"), tr("Second picture"), tr("Third picture")};
    for (int picture = 0; picture < int(names.size()); ++picture) {
        auto* label = new PaneLabel(names[std::size_t(picture)], methods, &viewport);
        label->hide();
        connect(label, &PaneLabel::methodChosen, this,
                [this, picture](const QString& key) { Q_EMIT methodChosen(picture, key); });
        m_labels.push_back(label);
    }
    connect(&viewport, &Viewport::panesChanged, this, &CompareView::placeLabels);
    setComposition({});
}

void CompareView::setComposition(const Composition& composition) {
    m_composition = composition;
    setVisible(composition.mode != Mode::Single);
    setFocusPolicy(isWiping() ? Qt::TabFocus : Qt::NoFocus);
    if (!isWiping()) m_viewport.unsetCursor();
    m_viewport.setMouseTracking(isWiping());
    setAccessibleDescription(tr("At %1 % of the width and %2 % of the height, turned by %3°")
                                 .arg(composition.wipeCenter.x * 100, 0, 'f', 0)
                                 .arg(composition.wipeCenter.y * 100, 0, 'f', 0)
                                 .arg(composition.wipeAngle, 0, 'f', 0));
    placeLabels();
    update();
}

void CompareView::setActiveMethod(const std::string& key) {
    m_active = key;
    placeLabels();
}

void CompareView::setFigures(std::size_t picture, const QStringList& figures) {
    m_labels[picture]->setFigures(figures);
    placeLabels();
}

void CompareView::placeLabels() {
    const std::vector<Pane> panes = m_viewport.panes();
    // The viewport may be about to show, or show already, what this has not been told yet.
    const bool isComparing = m_composition.mode != Mode::Single && panes.size() == m_composition.shownCount();
    const QRect whole = m_viewport.rect();
    const WipeLine line = wipeLine(m_composition, whole.size());
    // Of a wipe whose line lies flat, one label is above and one below it.
    const bool isStacked = isWiping() && std::abs(line.normal.y) > std::abs(line.normal.x);
    const bool isSwapped = isWiping() && (isStacked ? line.normal.y : line.normal.x) < 0;
    for (std::size_t i = 0; i < m_labels.size(); ++i) {
        PaneLabel& label = *m_labels[i];
        label.setVisible(isComparing && i < panes.size());
        if (label.isHidden()) continue;
        label.setMethod(m_composition.methods[i], m_composition.methods[i] == m_active);
        const bool isApart = m_composition.mode == Mode::SideBySide;
        const QRect room = isApart ? panes[i].rect.toRect() : whole;
        const bool meetsSphere = room.top() == whole.top() && room.right() >= whole.right() - sphereRoom;
        const int width = room.width() - 2 * margin;
        const int besideSphere = width - (meetsSphere ? sphereRoom - margin : 0);
        // In a narrow pane it goes below the light.
        const bool isBelow = isApart && meetsSphere && besideSphere < label.leastWidth();
        const QSize size = label.fit(isBelow ? width : isApart ? besideSphere : (besideSphere - margin) / 2);
        const bool isFar = !isApart && (i == 1) != isSwapped;
        QPoint corner = room.topLeft() + QPoint(margin, isBelow ? sphereRoom : margin);
        if (isFar && isStacked) corner.setY(room.bottom() - noteRoom - size.height());
        if (isFar && !isStacked) corner.setX(room.right() - sphereRoom - size.width());
        label.move(corner);
        label.raise();
    }
}

glm::dvec2 CompareView::along() const {
    const glm::dvec2 normal = wipeLine(m_composition, size()).normal;
    return {-normal.y, normal.x};
}

QPointF CompareView::handlePosition(Handle handle) const {
    const glm::dvec2 center = m_composition.wipeCenter * glm::dvec2(width(), height());
    const double arm = shareOfArm * std::min(width(), height());
    if (handle == Handle::Start) return pointOf(center - along() * arm);
    if (handle == Handle::End) return pointOf(center + along() * arm);
    return pointOf(center);
}

CompareView::Handle CompareView::handleAt(QPointF position) const {
    if (!isWiping() || isHidden()) return Handle::None;
    for (const Handle handle : {Handle::Start, Handle::End})
        if (QLineF(position, handlePosition(handle)).length() <= handleReach) return handle;
    const WipeLine line = wipeLine(m_composition, size());
    const double distance = std::abs(glm::dot(vectorOf(position), line.normal) - line.offset);
    const bool isAtMiddle = QLineF(position, handlePosition(Handle::Line)).length() <= handleReach;
    return distance <= reach || isAtMiddle ? Handle::Line : Handle::None;
}

void CompareView::edit(const Composition& composition) {
    if (composition == m_composition) return;
    setComposition(composition);
    Q_EMIT compositionEdited(composition);
}

void CompareView::drag(QPointF position, Qt::KeyboardModifiers modifiers) {
    Composition moved = m_composition;
    if (m_dragged == Handle::Line) {
        const QPointF center = position - m_grip;
        moved.wipeCenter = {std::clamp(center.x() / std::max(width(), 1), 0.0, 1.0),
                            std::clamp(center.y() / std::max(height(), 1), 0.0, 1.0)};
    } else {
        const QPointF arm = position - handlePosition(Handle::Line);
        if (arm.manhattanLength() < 2) return;
        // The end of the line lies a quarter turn from its normal.
        double angle = glm::degrees(std::atan2(arm.y(), arm.x())) - 90;
        if (m_dragged == Handle::Start) angle += 180;
        if (modifiers & Qt::ShiftModifier) angle = std::round(angle / turnStep) * turnStep;
        moved.wipeAngle = wrapped(angle);
    }
    edit(moved);
}

void CompareView::showCursor(QPointF position) {
    switch (m_dragged == Handle::None ? handleAt(position) : m_dragged) {
        case Handle::None:
            return m_viewport.unsetCursor();
        case Handle::Line: {
            const glm::dvec2 normal = wipeLine(m_composition, size()).normal;
            const bool isFlat = std::abs(normal.y) > std::abs(normal.x);
            return m_viewport.setCursor(isFlat ? Qt::SplitVCursor : Qt::SplitHCursor);
        }
        case Handle::Start:
        case Handle::End:
            return m_viewport.setCursor(m_dragged == Handle::None ? Qt::OpenHandCursor
                                                                  : Qt::ClosedHandCursor);
    }
}

bool CompareView::eventFilter(QObject* watched, QEvent* event) {
    if (watched != &m_viewport || !isWiping()) return QWidget::eventFilter(watched, event);
    const auto* mouse = static_cast<const QMouseEvent*>(event);
    switch (event->type()) {
        case QEvent::MouseButtonPress:
            if (mouse->button() != Qt::LeftButton || mouse->modifiers() & ~Qt::ShiftModifier) break;
            m_dragged = handleAt(mouse->position());
            if (m_dragged == Handle::None) break;
            m_grip = mouse->position() - handlePosition(Handle::Line);
            showCursor(mouse->position());
            return true;
        case QEvent::MouseMove:
            showCursor(mouse->position());
            if (m_dragged == Handle::None) break;
            drag(mouse->position(), mouse->modifiers());
            return true;
        case QEvent::MouseButtonRelease:
            if (m_dragged == Handle::None || mouse->button() != Qt::LeftButton) break;
            m_dragged = Handle::None;
            showCursor(mouse->position());
            return true;
        default:
            break;
    }
    return QWidget::eventFilter(watched, event);
}

void CompareView::keyPressEvent(QKeyEvent* event) {
    Composition moved = m_composition;
    const Composition initial;
    switch (event->key()) {
        case Qt::Key_Left:
            moved.wipeCenter.x -= keyMove;
            break;
        case Qt::Key_Right:
            moved.wipeCenter.x += keyMove;
            break;
        case Qt::Key_Up:
            moved.wipeCenter.y -= keyMove;
            break;
        case Qt::Key_Down:
            moved.wipeCenter.y += keyMove;
            break;
        case Qt::Key_PageUp:
            moved.wipeAngle = wrapped(moved.wipeAngle - keyTurn);
            break;
        case Qt::Key_PageDown:
            moved.wipeAngle = wrapped(moved.wipeAngle + keyTurn);
            break;
        case Qt::Key_Home:
            moved.wipeCenter = initial.wipeCenter;
            moved.wipeAngle = initial.wipeAngle;
            break;
        default:
            return QWidget::keyPressEvent(event);
    }
    moved.wipeCenter = glm::clamp(moved.wipeCenter, 0.0, 1.0);
    edit(moved);
}

void CompareView::focusInEvent(QFocusEvent*) {
    update();
}

void CompareView::focusOutEvent(QFocusEvent*) {
    update();
}

void CompareView::paintEvent(QPaintEvent*) {
    if (!isWiping()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    drawLine(painter);
}

void CompareView::drawLine(QPainter& painter) const {
    const QPointF middle = handlePosition(Handle::Line);
    const QPointF way = pointOf(along() * double(width() + height()));
    const QColor color = hasFocus() ? palette().color(QPalette::Highlight) : QColor(Qt::white);
    // Darker and wider below, so that it is seen on any paint.
    const std::initializer_list<std::pair<QColor, double>> strokes{{QColor(0, 0, 0, 150), 3.4}, {color, 1.4}};
    for (const auto& [stroke, width] : strokes) {
        painter.setPen(QPen(stroke, width));
        painter.drawLine(middle - way, middle + way);
    }
    for (const Handle handle : {Handle::Start, Handle::End, Handle::Line}) {
        const double radius = handle == Handle::Line ? 7 : 4.5;
        painter.setPen(QPen(QColor(0, 0, 0, 150), 3.4));
        painter.setBrush(QColor(0x2e, 0x2e, 0x2e));
        painter.drawEllipse(handlePosition(handle), radius, radius);
        painter.setPen(QPen(color, 1.4));
        painter.drawEllipse(handlePosition(handle), radius, radius);
    }
}

}  // namespace chiaro::widgets
