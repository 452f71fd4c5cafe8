#pragma once

#include <glm/glm.hpp>

#include <QImage>
#include <QWidget>

#include <array>

namespace chiaro::widgets {

/// The crop quadrilateral's corners, top-left, top-right, bottom-right, bottom-left, in fractions of the
/// scan.
using CropQuad = std::array<glm::vec2, 4>;

/// Convex, clockwise (y down), inside the scan and no sliver: what sample::makeStrip can straighten.
bool isUsableCrop(const CropQuad& quad);

/// A scan and the quadrilateral that is cut from it. Corners, edges and the whole are dragged; the arrow keys
/// nudge what is selected (keys 1 to 4 a corner, 5 to 8 an edge, 0 the whole) by a scan pixel, with Shift by
/// ten. A drag stops where the crop would stop being usable; Escape takes it back.
class CropCanvas : public QWidget {
    Q_OBJECT

public:
    explicit CropCanvas(QWidget* parent = nullptr);

    /// `scanSize` in pixels of the scan itself, of which the picture may be a smaller copy.
    void setScan(const QImage& picture, QSize scanSize);
    void setCrop(const CropQuad& crop);
    const CropQuad& crop() const { return m_crop; }
    /// Which edge becomes the strip's dark end (0 top, 1 right, 2 bottom, 3 left); the light end is across.
    void setDarkEdge(int edge);

    /// Where a place on the scan, in fractions, lies on this widget, and back.
    QPointF toWidget(glm::vec2 fraction) const;
    glm::vec2 toFraction(QPointF position) const;

    QSize sizeHint() const override { return {280, 180}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

Q_SIGNALS:
    void cropEdited(const chiaro::widgets::CropQuad& crop);
    void editFinished();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    /// A corner, an edge (from the corner of the same number to the next) or the whole.
    struct Part {
        enum class Kind { None, Corner, Edge, Whole };
        Kind kind = Kind::None;
        int index = 0;
        bool holds(int corner) const;
        friend bool operator==(const Part&, const Part&) = default;
    };

    QRectF pictureArea() const;
    Part partAt(QPointF position) const;
    void move(const CropQuad& from, Part part, glm::vec2 by);
    void takeBack();
    void paintQuad(QPainter& painter) const;
    void paintEnds(QPainter& painter, const QPolygonF& outline) const;
    void updateCursor(Part part);

    QImage m_picture;
    QSize m_scanSize;
    CropQuad m_crop{glm::vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    int m_darkEdge = 3;
    Part m_selected{Part::Kind::Whole, 0};
    Part m_hovered;
    bool m_dragging = false;
    bool m_nudged = false;
    CropQuad m_pressedCrop{};
    QPointF m_pressedAt;
};

}  // namespace chiaro::widgets
