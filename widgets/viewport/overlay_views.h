#pragma once

#include "core/scene/camera.h"
#include "core/views/view.h"

#include <QImage>
#include <QWidget>

#include <array>
#include <vector>

namespace chiaro::widgets {

/// What is marked over the picture of one object, in its own space.
struct ViewMarks {
    struct Marked {
        views::View view;  ///< framed
        bool isPlaced = false;
    };
    using Triangle = std::array<glm::vec3, 3>;

    std::vector<Marked> views = {};
    int selected = -1;
    std::vector<Triangle> laterFaces = {};        ///< that only a further pass covers
    std::vector<Triangle> unreachableFaces = {};  ///< without area
    glm::mat4 transform{1};                       ///< object to world
};

/// Lies over a viewport and marks the views of an object: a small frame for each, facing the object, its tick
/// upwards; the selected one's whole frustum; and the faces that the first pass did not cover, seen through
/// what hides them, for hidden they mostly are. Lets the pointer through. The same over OpenGL's pictures and
/// over the CPU renderer's.
class OverlayViews : public QWidget {
    Q_OBJECT

public:
    /// Follows the size of its parent.
    explicit OverlayViews(QWidget* viewport);

    void setMarks(ViewMarks marks);
    /// Lies below the marks, over all of the picture; null: none.
    void setPicture(const QImage& picture);
    /// The camera of the picture below.
    void setCamera(const scene::Camera& camera);
    /// Where that picture is seen, more than once where methods are compared; all of the widget at first.
    void setPanes(std::vector<QRectF> panes);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void drawMarks(QPainter& painter, const QRectF& pane);

    ViewMarks m_marks;
    QImage m_picture;
    scene::Camera m_camera;
    std::vector<QRectF> m_panes;
};

}  // namespace chiaro::widgets
