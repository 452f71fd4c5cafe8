#include "core/scene/camera.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace chiaro::scene {

float Camera::eyeDistance() const {
    return distance * radius / std::sin(glm::radians(fieldOfView) * 0.5f);
}

// Far enough to hold an object that the artist moved well out of the target sphere; a near plane at a
// hundredth of the way leaves 24-bit depth buffers fine steps.
float Camera::nearPlane() const {
    return std::max(eyeDistance() * 0.01f, eyeDistance() - 20 * radius);
}

float Camera::farPlane() const {
    return eyeDistance() + 1000 * radius;
}

glm::mat3 Camera::basis() const {
    const float a = glm::radians(azimuth);
    const float e = glm::radians(elevation);
    // Built from the angles, not by looking at a point, so that "up" exists at the poles.
    const glm::vec3 right(std::cos(a), 0, -std::sin(a));
    const glm::vec3 up(-std::sin(e) * std::sin(a), std::cos(e), -std::sin(e) * std::cos(a));
    const glm::vec3 back(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a));
    return {right, up, back};
}

glm::vec3 Camera::position() const {
    return target + basis()[2] * eyeDistance();
}

glm::mat4 Camera::view() const {
    const glm::mat4 rotation(glm::transpose(basis()));
    const glm::mat4 toTarget = glm::translate(glm::mat4(1), -target);
    return glm::translate(glm::mat4(1), glm::vec3(0, 0, -eyeDistance())) * rotation * toTarget;
}

glm::vec2 Camera::halfExtent(int width, int height) const {
    const float half = std::tan(glm::radians(fieldOfView) * 0.5f);
    const float smaller = float(std::min(width, height));
    return glm::vec2(float(width), float(height)) * (half / smaller);
}

glm::mat4 Camera::projection(int width, int height) const {
    const glm::vec2 extent = halfExtent(width, height) * nearPlane();
    return glm::frustum(-extent.x, extent.x, -extent.y, extent.y, nearPlane(), farPlane());
}

Camera Camera::framed(const Bounds& bounds) const {
    Camera camera = *this;
    camera.target = bounds.center();
    camera.radius = bounds.radius > 0 ? bounds.radius : 1;
    return camera;
}

}  // namespace chiaro::scene
