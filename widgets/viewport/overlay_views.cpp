#include "widgets/viewport/overlay_views.h"

#include <QtWidgets>

#include <functional>
#include <optional>

namespace chiaro::widgets {

namespace {

// In halves of a map's side.
constexpr double frameDistance = 1.25;
constexpr double frameSide = 0.09;
constexpr double tickHeight = 0.07;

constexpr std::size_t manyFaces = 20'000;  // from here on each is a point, or the window would wait
const QColor unreachableColor(0xe0, 0x5a, 0x4a);
const QColor laterColor(0x4f, 0xc3, 0xd9);  // which no paint of wood, skin or oil is mistaken for

/// Object space to the widget.
class Screen {
public:
    Screen(const scene::Camera& camera, const glm::mat4& transform, const QRectF& pane)
        : m_matrix(
              glm::dmat4(camera.projection(std::max(int(pane.width()), 1), std::max(int(pane.height()), 1)) *
                         camera.view() * transform)),
          m_pane(pane) {}

    glm::dvec4 clip(const glm::dvec3& point) const { return m_matrix * glm::dvec4(point, 1); }
    /// Null behind the eye.
    std::optional<QPointF> place(const glm::dvec3& point) const {
        const glm::dvec4 at = clip(point);
        return at.w > nearest ? std::optional(toWidget(at)) : std::nullopt;
    }
    /// The part of a line in front of the eye.
    void draw(QPainter& painter, const glm::dvec3& from, const glm::dvec3& to) const {
        glm::dvec4 a = clip(from);
        glm::dvec4 b = clip(to);
        if (a.w <= nearest && b.w <= nearest) return;
        if (a.w <= nearest) a += (b - a) * ((nearest - a.w) / (b.w - a.w));
        if (b.w <= nearest) b += (a - b) * ((nearest - b.w) / (a.w - b.w));
        painter.drawLine(toWidget(a), toWidget(b));
    }

private:
    static constexpr double nearest = 1e-9;
    QPointF toWidget(const glm::dvec4& at) const {
        const double w = std::max(at.w, nearest);
        return m_pane.topLeft() +
               QPointF((at.x / w + 1) / 2 * m_pane.width(), (1 - at.y / w) / 2 * m_pane.height());
    }

    glm::dmat4 m_matrix;
    QRectF m_pane;
};

using Corners = std::array<glm::dvec3, 4>;

Corners square(const glm::dvec3& center, const glm::dmat3& basis, double half) {
    const glm::dvec3 x = basis[0] * half;
    const glm::dvec3 y = basis[1] * half;
    return {center - x - y, center + x - y, center + x + y, center - x + y};
}

void drawOutline(QPainter& painter, const Screen& screen, const Corners& corners) {
    for (std::size_t i = 0; i < 4; ++i) screen.draw(painter, corners[i], corners[(i + 1) % 4]);
}

/// Where the eye is marked: outside the object, however far an orthographic view's eye is.
glm::dvec3 markOf(const views::View& view) {
    return view.target + view.basis()[2] * (view.halfExtent * frameDistance);
}

/// Draws lines in a colour over darker, wider ones: clear on any paint.
void outlined(QPainter& painter, const QColor& color, const std::function<void()>& draw) {
    painter.setPen(QPen(QColor(0, 0, 0, color.alpha() * 2 / 3), 3.4));
    draw();
    painter.setPen(QPen(color, 1.4));
    draw();
}

void drawNumber(QPainter& painter, QPointF center, int number, const QColor& color) {
    const QRectF box(center - QPointF(12, 8), QSizeF(24, 16));
    painter.setPen(QColor(0, 0, 0, color.alpha()));
    for (const QPointF& by : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
        painter.drawText(box.translated(by), Qt::AlignCenter, QString::number(number));
    painter.setPen(color);
    painter.drawText(box, Qt::AlignCenter, QString::number(number));
}

void drawFrame(QPainter& painter, const Screen& screen, const ViewMarks::Marked& marked,
               const QColor& color) {
    const views::View& view = marked.view;
    const glm::dmat3 basis = view.basis();
    const glm::dvec3 center = markOf(view);
    const double half = view.halfExtent * frameSide;
    const Corners corners = square(center, basis, half);
    QPolygonF polygon;
    for (const glm::dvec3& corner : corners)
        if (const auto place = screen.place(corner)) polygon << *place;
    if (marked.isPlaced && polygon.size() == 4) {
        QPainterPath inside;
        inside.addPolygon(polygon);
        QColor fill = color;
        fill.setAlpha(fill.alpha() / 2);
        painter.fillPath(inside, fill);
    }
    const glm::dvec3 tip = center + basis[1] * (half + view.halfExtent * tickHeight);
    outlined(painter, color, [&] {
        drawOutline(painter, screen, corners);
        screen.draw(painter, corners[2], tip);
        screen.draw(painter, corners[3], tip);
        screen.draw(painter, center, center - basis[2] * (view.halfExtent * frameSide));
    });
}

void drawFrustum(QPainter& painter, const Screen& screen, const views::View& view) {
    const glm::dmat3 basis = view.basis();
    const auto section = [&](double depth) {
        const bool isPerspective = view.projection == views::Projection::Perspective;
        const double half = view.halfExtent * (isPerspective ? depth / view.eyeDistance : 1);
        return square(view.eye() - basis[2] * depth, basis, half);
    };
    const Corners near = section(view.nearDepth);
    const Corners far = section(view.farDepth);
    drawOutline(painter, screen, near);
    drawOutline(painter, screen, far);
    for (std::size_t i = 0; i < 4; ++i) screen.draw(painter, near[i], far[i]);
}

void drawFaces(QPainter& painter, const Screen& screen, const std::vector<ViewMarks::Triangle>& faces,
               QColor color) {
    QColor fill = color;
    fill.setAlpha(110);
    painter.setPen(QPen(color, 1));
    painter.setBrush(fill);
    for (const ViewMarks::Triangle& face : faces) {
        QPolygonF polygon;
        for (const glm::vec3& corner : face)
            if (const auto place = screen.place(glm::dvec3(corner))) polygon << *place;
        if (polygon.size() < 3) continue;
        if (faces.size() < manyFaces)
            painter.drawPolygon(polygon);
        else
            painter.drawPoint(polygon.front());
    }
    painter.setBrush(Qt::NoBrush);
}

}  // namespace

OverlayViews::OverlayViews(QWidget* viewport) : QWidget(viewport) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    viewport->installEventFilter(this);
    setGeometry(viewport->rect());
}

bool OverlayViews::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
    return QWidget::eventFilter(watched, event);
}

void OverlayViews::setMarks(ViewMarks marks) {
    m_marks = std::move(marks);
    update();
}

void OverlayViews::setPicture(const QImage& picture) {
    m_picture = picture;
    update();
}

void OverlayViews::setCamera(const scene::Camera& camera) {
    m_camera = camera;
    update();
}

void OverlayViews::setPanes(std::vector<QRectF> panes) {
    m_panes = std::move(panes);
    update();
}

void OverlayViews::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (m_panes.empty()) return drawMarks(painter, rect());
    for (const QRectF& pane : m_panes) {
        painter.setClipRect(pane);
        drawMarks(painter, pane);
    }
}

void OverlayViews::drawMarks(QPainter& painter, const QRectF& pane) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!m_picture.isNull()) painter.drawImage(pane, m_picture);
    painter.setRenderHint(QPainter::Antialiasing, false);
    const Screen screen(m_camera, m_marks.transform, pane);
    drawFaces(painter, screen, m_marks.laterFaces, laterColor);
    drawFaces(painter, screen, m_marks.unreachableFaces, unreachableColor);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor accent = palette().color(QPalette::Highlight);
    QFont small = font();
    small.setPixelSize(11);
    painter.setFont(small);
    for (std::size_t i = 0; i < m_marks.views.size(); ++i) {
        const ViewMarks::Marked& marked = m_marks.views[i];
        const bool isSelected = int(i) == m_marks.selected;
        QColor color = isSelected ? QColor(Qt::white) : marked.isPlaced ? accent : QColor(0xc8, 0xc8, 0xc8);
        // Those on the far side of the object step back.
        const double depth = screen.clip(markOf(marked.view)).w;
        if (depth > screen.clip(marked.view.target).w && !isSelected) color.setAlpha(80);
        drawFrame(painter, screen, marked, color);
        if (const auto place = screen.place(markOf(marked.view)); place && color.alpha() == 255)
            drawNumber(painter, *place, int(i) + 1, color);
        if (!isSelected) continue;
        painter.setPen(QPen(QColor(255, 255, 255, 120), 1, Qt::DashLine));
        drawFrustum(painter, screen, marked.view);
    }
}

}  // namespace chiaro::widgets
