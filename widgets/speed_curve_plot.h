#pragma once

#include "core/gradient/gradient.h"

#include <QImage>
#include <QWidget>

namespace chiaro::widgets {

/// The speed curve u(x) (§3.1) over the colours it picks: x is the place on the strip, u the place on the
/// sorted gradient, which is painted behind. Below lie the column averages and, right under them, G(u(x)).
///
/// Points are dragged, never past their neighbours, so that the curve stays monotone; a double click adds
/// one, Delete removes the selected; Page Up and Page Down select, the arrow keys nudge; Escape takes a drag
/// back.
class SpeedCurvePlot : public QWidget {
    Q_OBJECT

public:
    explicit SpeedCurvePlot(QWidget* parent = nullptr);

    void setCurve(const gradient::SpeedCurve& curve);
    const gradient::SpeedCurve& curve() const { return m_curve; }
    /// Averages and sorted colours, W of each; empty ones empty the plot.
    void setColors(const gradient::Gradient& averages, const gradient::Gradient& sorted);

    /// An index into the curve's points.
    int selected() const { return m_selected; }
    /// (0, 0) when none is.
    glm::vec2 selectedPlace() const;
    void select(int point);
    /// As near to the place as the neighbours and the fixed ends let it.
    void moveSelected(glm::vec2 place);
    void removeSelected();

    QPointF toWidget(glm::vec2 place) const;
    glm::vec2 toPlace(QPointF position) const;

    QSize sizeHint() const override { return {280, 230}; }
    QSize minimumSizeHint() const override { return {160, 170}; }

Q_SIGNALS:
    void curveEdited(const chiaro::gradient::SpeedCurve& curve);
    void editFinished();
    void selectionChanged(int point);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    QRectF plotArea() const;
    int pointAt(QPointF position) const;
    bool isEnd(int point) const;
    void add(glm::vec2 place);
    void edit(const gradient::SpeedCurve& curve);
    void finishNudge();
    void paintColors(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;
    QImage followed() const;

    gradient::SpeedCurve m_curve;
    gradient::Gradient m_sorted;
    QImage m_averagesBar;
    QImage m_sortedBar;
    int m_selected = -1;
    bool m_dragging = false;
    gradient::SpeedCurve m_pressedCurve;  ///< before the drag
    bool m_nudged = false;
    QPointF m_grip;  ///< from the pointer to the point it holds
};

}  // namespace chiaro::widgets
