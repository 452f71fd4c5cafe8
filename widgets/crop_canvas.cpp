#include "widgets/crop_canvas.h"

#include <QtWidgets>

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr double frame = 10;           ///< px around the picture, room for handles at its corners
constexpr double cornerReach = 10;     ///< px from a corner that still take hold of it
constexpr double edgeReach = 6;        ///< px from an edge
constexpr double smallestTurn = 1e-4;  ///< twice the area, in fractions, of the triangle at each corner

double cross(glm::vec2 a, glm::vec2 b) {
    return double(a.x) * b.y - double(a.y) * b.x;
}

double distanceToSegment(QPointF point, QPointF from, QPointF to) {
    const QPointF along = to - from;
    const double length = QPointF::dotProduct(along, along);
    const double place =
        length > 0 ? std::clamp(QPointF::dotProduct(point - from, along) / length, 0.0, 1.0) : 0;
    return QLineF(point, from + place * along).length();
}

}  // namespace

bool isUsableCrop(const CropQuad& quad) {
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec2 corner = quad[i];
        if (corner.x < 0 || corner.x > 1 || corner.y < 0 || corner.y > 1) return false;
        if (cross(quad[(i + 1) % 4] - corner, quad[(i + 2) % 4] - quad[(i + 1) % 4]) < smallestTurn)
            return false;
    }
    return true;
}

bool CropCanvas::Part::holds(int corner) const {
    switch (kind) {
        case Kind::None:
            return false;
        case Kind::Corner:
            return corner == index;
        case Kind::Edge:
            return corner == index || corner == (index + 1) % 4;
        case Kind::Whole:
            return true;
    }
    return false;
}

CropCanvas::CropCanvas(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Crop"));
    setToolTip(
        tr("Drag the corners, edges or the whole to cut the strip out of the scan.\n"
           "Keys 1 to 4 select a corner, 5 to 8 an edge, 0 the whole; arrow keys nudge it by a pixel, with "
           "Shift "
           "by ten."));
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setMinimumHeight(90);
}

void CropCanvas::setScan(const QImage& picture, QSize scanSize) {
    m_picture = picture;
    m_scanSize = scanSize;
    updateGeometry();
    update();
}

void CropCanvas::setCrop(const CropQuad& crop) {
    m_crop = crop;
    update();
}

void CropCanvas::setDarkEdge(int edge) {
    m_darkEdge = edge;
    update();
}

int CropCanvas::heightForWidth(int width) const {
    if (m_scanSize.isEmpty()) return 120;
    const double height = (width - 2 * frame) * m_scanSize.height() / m_scanSize.width() + 2 * frame;
    return int(std::clamp(height, 90.0, 260.0));
}

QRectF CropCanvas::pictureArea() const {
    const QRectF room = QRectF(rect()).adjusted(frame, frame, -frame, -frame);
    const QSizeF size = QSizeF(m_scanSize).scaled(room.size(), Qt::KeepAspectRatio);
    return {room.center() - QPointF(size.width(), size.height()) / 2, size};
}

QPointF CropCanvas::toWidget(glm::vec2 fraction) const {
    const QRectF area = pictureArea();
    return area.topLeft() + QPointF(double(fraction.x) * area.width(), double(fraction.y) * area.height());
}

glm::vec2 CropCanvas::toFraction(QPointF position) const {
    const QRectF area = pictureArea();
    if (area.isEmpty()) return {0, 0};
    const QPointF inside = position - area.topLeft();
    return {float(inside.x() / area.width()), float(inside.y() / area.height())};
}

CropCanvas::Part CropCanvas::partAt(QPointF position) const {
    if (m_picture.isNull()) return {};
    QPolygonF outline;
    for (const glm::vec2& corner : m_crop) outline << toWidget(corner);
    for (int i = 0; i < 4; ++i)
        if (QLineF(position, outline[i]).length() <= cornerReach) return {Part::Kind::Corner, i};
    for (int i = 0; i < 4; ++i)
        if (distanceToSegment(position, outline[i], outline[(i + 1) % 4]) <= edgeReach)
            return {Part::Kind::Edge, i};
    if (outline.containsPoint(position, Qt::OddEvenFill)) return {Part::Kind::Whole, 0};
    return {};
}

void CropCanvas::move(const CropQuad& from, Part part, glm::vec2 by) {
    // The whole and edges stop as one at the scan's border, so that they keep their shape.
    glm::vec2 low(-1);
    glm::vec2 high(1);
    for (int i = 0; i < 4; ++i) {
        if (!part.holds(i)) continue;
        low = glm::max(low, -from[std::size_t(i)]);
        high = glm::min(high, 1.0F - from[std::size_t(i)]);
    }
    by = glm::clamp(by, low, high);

    const auto moved = [&](float share) {
        CropQuad crop = from;
        for (int i = 0; i < 4; ++i)
            if (part.holds(i))
                crop[std::size_t(i)] =
                    glm::clamp(from[std::size_t(i)] + by * share, glm::vec2(0), glm::vec2(1));
        return crop;
    };
    CropQuad crop = moved(1);
    if (!isUsableCrop(crop)) {
        float possible = 0;
        float impossible = 1;
        for (int step = 0; step < 16; ++step) {
            const float middle = (possible + impossible) / 2;
            (isUsableCrop(moved(middle)) ? possible : impossible) = middle;
        }
        crop = moved(possible);
    }
    if (crop == m_crop) return;
    m_crop = crop;
    update();
    Q_EMIT cropEdited(m_crop);
}

void CropCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const Part part = partAt(event->position());
    if (part.kind == Part::Kind::None) return;
    m_selected = part;
    m_dragging = true;
    m_pressedCrop = m_crop;
    m_pressedAt = event->position();
    updateCursor(part);
    update();
}

void CropCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragging) {
        move(m_pressedCrop, m_selected, toFraction(event->position()) - toFraction(m_pressedAt));
        return;
    }
    const Part part = partAt(event->position());
    if (part == m_hovered) return;
    m_hovered = part;
    updateCursor(part);
    update();
}

void CropCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_dragging) return;
    m_dragging = false;
    updateCursor(m_selected);
    Q_EMIT editFinished();
}

void CropCanvas::takeBack() {
    m_dragging = false;
    updateCursor(m_selected);
    if (m_crop != m_pressedCrop) {
        m_crop = m_pressedCrop;
        update();
        Q_EMIT cropEdited(m_crop);
    }
    Q_EMIT editFinished();
}

void CropCanvas::leaveEvent(QEvent* event) {
    m_hovered = {};
    update();
    QWidget::leaveEvent(event);
}

bool CropCanvas::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        // Digits select parts here, whatever else they are shortcuts of.
        const auto* key = static_cast<QKeyEvent*>(event);
        if (!m_scanSize.isEmpty() && key->modifiers() == Qt::NoModifier && key->key() >= Qt::Key_0 &&
            key->key() <= Qt::Key_8)
            event->accept();
    }
    return QWidget::event(event);
}

void CropCanvas::keyPressEvent(QKeyEvent* event) {
    if (m_scanSize.isEmpty()) return QWidget::keyPressEvent(event);
    if (event->key() == Qt::Key_Escape && m_dragging) return takeBack();
    if (event->key() >= Qt::Key_0 && event->key() <= Qt::Key_8) {
        const int number = event->key() - Qt::Key_0;
        if (number == 0)
            m_selected = {Part::Kind::Whole, 0};
        else if (number <= 4)
            m_selected = {Part::Kind::Corner, number - 1};
        else
            m_selected = {Part::Kind::Edge, number - 5};
        update();
        return;
    }
    glm::vec2 by(0);
    if (event->key() == Qt::Key_Left) by.x = -1;
    if (event->key() == Qt::Key_Right) by.x = 1;
    if (event->key() == Qt::Key_Up) by.y = -1;
    if (event->key() == Qt::Key_Down) by.y = 1;
    if (by == glm::vec2(0)) return QWidget::keyPressEvent(event);
    if (event->modifiers() & Qt::ShiftModifier) by *= 10.0F;
    m_nudged = true;
    move(m_crop, m_selected, by / glm::vec2(m_scanSize.width(), m_scanSize.height()));
}

void CropCanvas::keyReleaseEvent(QKeyEvent* event) {
    if (event->isAutoRepeat() || !m_nudged) return QWidget::keyReleaseEvent(event);
    m_nudged = false;
    Q_EMIT editFinished();
}

void CropCanvas::focusOutEvent(QFocusEvent* event) {
    if (m_nudged) {
        m_nudged = false;
        Q_EMIT editFinished();
    }
    QWidget::focusOutEvent(event);
    update();
}

void CropCanvas::updateCursor(Part part) {
    switch (part.kind) {
        case Part::Kind::None:
            return unsetCursor();
        case Part::Kind::Corner:
            return setCursor(m_dragging ? Qt::BlankCursor : Qt::CrossCursor);
        case Part::Kind::Edge:
            return setCursor(part.index % 2 == 0 ? Qt::SizeVerCursor : Qt::SizeHorCursor);
        case Part::Kind::Whole:
            return setCursor(m_dragging ? Qt::ClosedHandCursor : Qt::OpenHandCursor);
    }
}

void CropCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (m_picture.isNull()) return;
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter.drawImage(pictureArea(), m_picture);
    paintQuad(painter);
}

void CropCanvas::paintQuad(QPainter& painter) const {
    QPolygonF outline;
    for (const glm::vec2& corner : m_crop) outline << toWidget(corner);

    QPainterPath outside;
    outside.addRect(pictureArea());
    QPainterPath inside;
    inside.addPolygon(outline);
    inside.closeSubpath();
    painter.fillPath(outside.subtracted(inside), QColor(0, 0, 0, 150));

    const QColor accent = palette().color(QPalette::Highlight);
    for (int i = 0; i < 4; ++i) {
        const bool active = m_selected.kind == Part::Kind::Edge && m_selected.index == i;
        const bool hovered = m_hovered.kind == Part::Kind::Edge && m_hovered.index == i;
        painter.setPen(QPen(QColor(0, 0, 0, 140), 3));
        painter.drawLine(outline[i], outline[(i + 1) % 4]);
        painter.setPen(QPen(active && hasFocus() ? accent : Qt::white, hovered ? 2 : 1.2));
        painter.drawLine(outline[i], outline[(i + 1) % 4]);
    }
    paintEnds(painter, outline);
    for (int i = 0; i < 4; ++i) {
        const bool selected = m_selected.kind == Part::Kind::Corner && m_selected.index == i;
        const bool hovered = m_hovered.kind == Part::Kind::Corner && m_hovered.index == i;
        painter.setPen(QPen(QColor(0, 0, 0, 180), 1));
        painter.setBrush(selected ? accent : QColor(Qt::white));
        const double reach = hovered || selected ? 5.5 : 4.5;
        painter.drawRect(QRectF(outline[i] - QPointF(reach, reach), QSizeF(2 * reach, 2 * reach)));
    }
}

void CropCanvas::paintEnds(QPainter& painter, const QPolygonF& outline) const {
    const auto middle = [&](int edge) { return (outline[edge] + outline[(edge + 1) % 4]) / 2; };
    painter.setPen(QPen(Qt::white, 1.2));
    painter.setBrush(QColor(24, 24, 24));
    painter.drawEllipse(middle(m_darkEdge), 4.5, 4.5);
    painter.setPen(QPen(QColor(24, 24, 24), 1.2));
    painter.setBrush(Qt::white);
    painter.drawEllipse(middle((m_darkEdge + 2) % 4), 4.5, 4.5);
}

}  // namespace chiaro::widgets
