#include "widgets/viewport/light_sphere.h"

#include "widgets/viewport/navigation.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr int diameter = 64;

}  // namespace

LightSphere::LightSphere(QWidget* parent) : QWidget(parent) {
    setFixedSize(diameter, diameter);
    setCursor(Qt::OpenHandCursor);
    setToolTip(tr("Drag to turn the light (Shift and the right button do so anywhere in the picture)"));
    setAccessibleName(tr("Light"));
}

void LightSphere::show(const std::vector<scene::Light>& lights, const scene::Camera& camera,
                       const gradient::Gradient& gradient) {
    m_lights = lights;
    m_camera = camera;
    m_gradient = gradient;
    update();
}

QImage LightSphere::rendered(int side) const {
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    const float radius = float(side) / 2;
    const glm::mat3 basis = m_camera.basis();
    for (int y = 0; y < side; ++y) {
        QRgb* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < side; ++x) {
            glm::vec2 at((float(x) + 0.5f - radius) / radius, (radius - float(y) - 0.5f) / radius);
            const float length = glm::length(at);
            const float coverage = std::clamp((1 - length) * radius, 0.0f, 1.0f);
            if (coverage == 0) continue;
            const float depth = std::sqrt(std::max(0.0f, 1 - length * length));
            const glm::vec3 normal = basis * glm::vec3(at, depth);
            // It stands for the scene: lights at a point are as near as they are there.
            const float light =
                scene::lightValue(m_lights, m_camera.target + normal * m_camera.radius, normal);
            const glm::vec4 color(gradient::lookUp(m_gradient, light), 1);
            const glm::ivec4 bytes(color * (coverage * 255) + 0.5f);
            row[x] = qRgba(bytes.r, bytes.g, bytes.b, bytes.a);
        }
    }
    return image;
}

void LightSphere::paintEvent(QPaintEvent*) {
    if (m_gradient.empty()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawImage(rect(), rendered(qRound(diameter * devicePixelRatioF())));
    QColor rim = palette().color(QPalette::Text);
    rim.setAlpha(150);
    painter.setPen(QPen(rim, 1.2));
    painter.drawEllipse(QRectF(rect()).adjusted(0.8, 0.8, -0.8, -0.8));
}

void LightSphere::mousePressEvent(QMouseEvent* event) {
    setCursor(Qt::ClosedHandCursor);
    mouseMoveEvent(event);
}

void LightSphere::mouseMoveEvent(QMouseEvent* event) {
    Q_EMIT lightDragged(lightAt(m_camera, event->position(), size()));
}

void LightSphere::mouseReleaseEvent(QMouseEvent*) {
    setCursor(Qt::OpenHandCursor);
    Q_EMIT dragFinished();
}

}  // namespace chiaro::widgets
