#include "widgets/viewport/camera_history.h"

namespace chiaro::widgets {

namespace {

constexpr std::size_t mostKept = 100;

}  // namespace

void CameraHistory::beginMove(const scene::Camera& camera) {
    if (m_isMoving) return;
    m_isMoving = true;
    m_future.clear();
    m_past.push_back(camera);
    if (m_past.size() > mostKept) m_past.erase(m_past.begin());
}

void CameraHistory::endMove(const scene::Camera& camera) {
    if (!m_isMoving) return;
    m_isMoving = false;
    if (m_past.back() == camera) m_past.pop_back();
}

std::optional<scene::Camera> CameraHistory::step(const scene::Camera& camera, Cameras& from, Cameras& to) {
    endMove(camera);
    if (from.empty()) return std::nullopt;
    to.push_back(camera);
    const scene::Camera there = from.back();
    from.pop_back();
    return there;
}

std::optional<scene::Camera> CameraHistory::back(const scene::Camera& camera) {
    return step(camera, m_past, m_future);
}

std::optional<scene::Camera> CameraHistory::forth(const scene::Camera& camera) {
    return step(camera, m_future, m_past);
}

void CameraHistory::clear() {
    m_past.clear();
    m_future.clear();
    m_isMoving = false;
}

}  // namespace chiaro::widgets
