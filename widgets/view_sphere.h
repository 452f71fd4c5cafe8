#pragma once

#include <glm/glm.hpp>

#include <QWidget>

#include <optional>
#include <vector>

namespace chiaro::widgets {

/// A viewpoint to show. Directions are in the object's space.
struct ViewMarker {
    glm::dvec3 direction{0, 0, 1};  ///< from the object towards the eye, any length but zero
    int number = 1;                 ///< as it is called
    int pass = 1;
    bool isPlaced = false;  ///< by the artist; else planned
    QString tooltip;
};

/// The viewpoints of an object as markers on a sphere around it (§4.3.1): a disc for a planned view, a square
/// for a placed one, hollow on the far side. A click selects, a drag moves a view, a drag beside one turns
/// the sphere, which is seen as through a turntable camera, +Y up.
///
/// Keys: Tab and Shift+Tab go through the views, arrows move the selected one (with Shift by less; with Ctrl,
/// or when none is selected, they turn the sphere), Delete removes it, Return locks it, Escape selects none.
///
/// It changes nothing by itself: whoever owns the views hears viewMoved() and sets them again.
class ViewSphere : public QWidget {
    Q_OBJECT

public:
    explicit ViewSphere(QWidget* parent = nullptr);

    /// May come amid a drag; the selected view is then the one that is held.
    void setViews(std::vector<ViewMarker> views);
    const std::vector<ViewMarker>& views() const { return m_views; }
    /// Where the viewport looks from, marked by a cross.
    void setCameraDirection(const std::optional<glm::dvec3>& direction);

    /// An index into views(); -1 when none is.
    int selected() const { return m_selected; }
    /// Emits nothing.
    void setSelected(int view);
    /// Turns the sphere so that the direction faces the artist.
    void face(const glm::dvec3& direction);

    /// Where a direction is on the widget, and whether it is on the near side.
    QPointF position(const glm::dvec3& direction) const;
    bool isNear(const glm::dvec3& direction) const;
    bool isDragging() const { return m_grip == Grip::View; }

    QSize sizeHint() const override { return {260, 220}; }
    QSize minimumSizeHint() const override { return {160, 160}; }

Q_SIGNALS:
    void selectionChanged(int view);
    void viewMoved(int view, const glm::dvec3& direction);  ///< to a unit direction; many in a drag
    void editFinished();
    void removeWanted(int view);
    void lockWanted(int view);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    enum class Grip { None, Pressed, View, Sphere };  ///< what the pointer holds

    glm::dmat3 basis() const;
    QPointF center() const { return QRectF(rect()).center(); }
    double radius() const;
    double markerRadius() const;
    int viewAt(QPointF position) const;
    glm::dvec3 directionAt(QPointF position, bool isNear) const;
    void select(int view);
    void turn(double azimuth, double elevation);
    bool nudge(QPoint step, Qt::KeyboardModifiers modifiers);
    void finishNudge();
    void describe();
    void paintSphere(QPainter& painter) const;
    void paintCircle(QPainter& painter, const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& at) const;
    void paintUp(QPainter& painter) const;
    void paintMarker(QPainter& painter, int view) const;
    void paintCamera(QPainter& painter) const;

    std::vector<ViewMarker> m_views;
    std::optional<glm::dvec3> m_cameraDirection;
    int m_selected = -1;
    double m_azimuth = 30;  ///< of the eye that looks at the sphere, degrees; as scene::Camera's
    double m_elevation = 20;
    Grip m_grip = Grip::None;
    QPointF m_pressed;  ///< where the button went down
    QPointF m_last;     ///< where the pointer was last
    QPointF m_offset;   ///< from the pointer to the centre of the marker that it holds
    bool m_wasNear = true;
    bool m_nudged = false;
};

}  // namespace chiaro::widgets
