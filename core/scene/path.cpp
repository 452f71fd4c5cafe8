#include "core/scene/path.h"

#include "core/base/monotone_curve.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace chiaro::scene {

namespace {

double smoothly(const std::vector<Channel::Key>& keys, double frame) {
    std::vector<double> frames, values;
    for (const Channel::Key& key : keys) {
        frames.push_back(key.frame);
        values.push_back(key.value);
    }
    return MonotoneCurve(std::move(frames), std::move(values), MonotoneCurve::Ends::Resting)(frame);
}

double straight(const std::vector<Channel::Key>& keys, double frame) {
    const auto after = std::ranges::upper_bound(keys, frame, {}, &Channel::Key::frame);
    const Channel::Key &b = *after, &a = *(after - 1);
    return a.value + (b.value - a.value) * (frame - a.frame) / (b.frame - a.frame);
}

template <class Value>
void apply(const Channel& channel, double frame, bool smooth, Value& value) {
    if (!channel.empty()) value = Value(channel.at(frame, smooth));
}

}  // namespace

double Channel::at(double frame, bool smooth) const {
    if (frame <= keys.front().frame) return keys.front().value;
    if (frame >= keys.back().frame) return keys.back().value;
    return smooth ? smoothly(keys, frame) : straight(keys, frame);
}

Path Path::turntable(int period) {
    Path path;
    path.cameraTurn = 360.0 / period;
    return path;
}

Path Path::lightSweep(int period) {
    Path path;
    path.lightTurn = 360.0 / period;
    return path;
}

Path Path::approaching() {
    Path path;
    path.approach = 0.96;
    return path;
}

View Path::at(double frame, const View& start) const {
    View view = start;
    Camera& camera = view.camera;
    apply(azimuth, frame, smooth, camera.azimuth);
    apply(elevation, frame, smooth, camera.elevation);
    apply(distance, frame, smooth, camera.distance);
    apply(fieldOfView, frame, smooth, camera.fieldOfView);
    camera.azimuth = float(double(camera.azimuth) + cameraTurn * (frame - 1));
    if (approach != 1)
        camera.distance =
            float(std::clamp(double(camera.distance) * std::pow(approach, frame - 1), 0.01, 100.0));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = glm::length_t(axis);
        apply(target[axis], frame, smooth, camera.target[i]);
        if (!view.lights.empty()) apply(light[axis], frame, smooth, view.lights.front().vector[i]);
    }
    // On the way from a direction to its opposite it may vanish.
    if (!view.lights.empty() && glm::length(view.lights.front().vector) == 0)
        view.lights.front().vector = start.lights.front().vector;
    if (lightTurn == 0) return view;
    const auto turn = float(glm::radians(lightTurn * (frame - 1)));
    for (Light& one : view.lights)
        one.vector = glm::mat3(glm::rotate(glm::mat4(1), turn, glm::vec3(0, 1, 0))) * one.vector;
    return view;
}

}  // namespace chiaro::scene
