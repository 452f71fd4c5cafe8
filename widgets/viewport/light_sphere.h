#pragma once

#include "core/gradient/gradient.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

#include <QWidget>

namespace chiaro::widgets {

/// A small sphere lit as the objects are and painted with a gradient: shows where the light is, and turns it
/// when dragged.
class LightSphere : public QWidget {
    Q_OBJECT

public:
    explicit LightSphere(QWidget* parent = nullptr);

    void show(const std::vector<scene::Light>& lights, const scene::Camera& camera,
              const gradient::Gradient& gradient);

Q_SIGNALS:
    void lightDragged(glm::vec3 direction);  ///< unit, world space: the light shines on the dragged point
    void dragFinished();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    QImage rendered(int side) const;

    std::vector<scene::Light> m_lights;
    scene::Camera m_camera;
    gradient::Gradient m_gradient;
};

}  // namespace chiaro::widgets
