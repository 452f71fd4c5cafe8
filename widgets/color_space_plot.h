#pragma once

#include "core/gradient/gradient.h"

#include <QWidget>

namespace chiaro::widgets {

/// A sample's way through RGB (the report's figure 9) in a cube that is turned: its column averages as
/// points, the sorted gradient G as a line through them, and the colours in use where they are others.
///
/// A drag turns the cube; so do the arrow keys; a double click or Home turns it back.
class ColorSpacePlot : public QWidget {
    Q_OBJECT

public:
    explicit ColorSpacePlot(QWidget* parent = nullptr);

    /// Of any number each; empty ones empty the plot.
    void setColors(const gradient::Gradient& averages, const gradient::Gradient& sorted);
    /// What is shown in place of the sorted gradient, in order, and the stops in it; empty for nothing.
    void setPath(const std::vector<glm::vec3>& colors, const std::vector<glm::vec3>& stops);

    /// Degrees around the green axis, and from above.
    double azimuth() const { return m_azimuth; }
    double elevation() const { return m_elevation; }
    /// The elevation stays within -90..90.
    void turn(double azimuth, double elevation);
    void turnBack();

    /// Where a colour, RGB in [0, 1], is drawn.
    QPointF toWidget(glm::vec3 color) const;

    QSize sizeHint() const override { return {280, 220}; }
    QSize minimumSizeHint() const override { return {160, 160}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// As seen: x right, y up, z towards the eye, from the cube's centre, its edge being 1.
    glm::dvec3 seen(glm::vec3 color) const;
    void paintCube(QPainter& painter, bool behind) const;
    void paintPoints(QPainter& painter) const;
    void paintLine(QPainter& painter, const std::vector<glm::vec3>& colors, double width) const;
    void paintStops(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;

    gradient::Gradient m_averages, m_sorted;
    std::vector<glm::vec3> m_path, m_stops;
    double m_azimuth = 0, m_elevation = 0;
    bool m_dragging = false;
    QPointF m_last;
};

}  // namespace chiaro::widgets
