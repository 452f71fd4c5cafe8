#include "core/scene/path.h"

#include "core/base/monotone_curve.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <set>

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

void Channel::set(double frame, double value) {
    const auto place = std::ranges::lower_bound(keys, frame, {}, &Key::frame);
    if (place != keys.end() && place->frame == frame)
        place->value = value;
    else
        keys.insert(place, {frame, value});
}

void Channel::remove(double frame) {
    std::erase_if(keys, [&](const Key& key) { return key.frame == frame; });
}

template <class Self>
auto Path::channels(Self& self, Part part) {
    std::vector<decltype(&self.azimuth)> list;
    if (part == Part::Camera) list = {&self.azimuth, &self.elevation, &self.distance, &self.fieldOfView};
    for (auto& axis : part == Part::Camera ? self.target : self.light) list.push_back(&axis);
    return list;
}

bool Path::moves() const {
    return cameraTurn != 0 || lightTurn != 0 || approach != 1 || !keyFrames(Part::Camera).empty() ||
           !keyFrames(Part::Light).empty();
}

std::vector<int> Path::keyFrames(Part part) const {
    std::set<int> frames;
    for (const Channel* channel : channels(*this, part))
        for (const Channel::Key& key : channel->keys) frames.insert(int(key.frame));
    return {frames.begin(), frames.end()};
}

void Path::setKey(int frame, const Camera& camera) {
    azimuth.set(frame, double(camera.azimuth));
    elevation.set(frame, double(camera.elevation));
    distance.set(frame, double(camera.distance));
    fieldOfView.set(frame, double(camera.fieldOfView));
    for (std::size_t axis = 0; axis < 3; ++axis)
        target[axis].set(frame, double(camera.target[glm::length_t(axis)]));
}

void Path::setKey(int frame, glm::vec3 lightVector) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        light[axis].set(frame, double(lightVector[glm::length_t(axis)]));
}

void Path::removeKey(Part part, int frame) {
    for (Channel* channel : channels(*this, part)) channel->remove(frame);
}

void Path::moveKey(Part part, int from, int to) {
    if (from == to) return;
    for (Channel* channel : channels(*this, part)) {
        const auto key = std::ranges::find(channel->keys, double(from), &Channel::Key::frame);
        if (key == channel->keys.end()) {
            channel->remove(to);
            continue;
        }
        const double value = key->value;
        channel->remove(from);
        channel->set(to, value);
    }
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
    if (!view.lights.empty() && view.lights.front().kind == Light::Kind::Directional &&
        glm::length(view.lights.front().vector) == 0)
        view.lights.front().vector = start.lights.front().vector;
    if (lightTurn == 0) return view;
    const auto turn = float(glm::radians(lightTurn * (frame - 1)));
    const glm::mat3 rotation(glm::rotate(glm::mat4(1), turn, glm::vec3(0, 1, 0)));
    for (Light& one : view.lights) {
        const glm::vec3 axis = one.kind == Light::Kind::Point ? camera.target : glm::vec3(0);
        one.vector = axis + rotation * (one.vector - axis);
    }
    return view;
}

}  // namespace chiaro::scene
