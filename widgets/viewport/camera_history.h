#pragma once

#include "core/scene/camera.h"

#include <optional>
#include <vector>

namespace chiaro::widgets {

/// Where the camera was before each move, to go back to and forth again. A drag, or a run of keys or wheel
/// turns, is one move. The last hundred are kept.
class CameraHistory {
public:
    /// A step of a move is about to be made from here: the first of it, or one more.
    void beginMove(const scene::Camera& camera);
    /// It ended here; one that led nowhere is forgotten.
    void endMove(const scene::Camera& camera);
    bool isMoving() const { return m_isMoving; }

    bool canGoBack() const { return !m_past.empty(); }
    bool canGoForth() const { return !m_future.empty(); }
    /// From here to where the camera was before the last move, or before the last going back.
    std::optional<scene::Camera> back(const scene::Camera& camera);
    std::optional<scene::Camera> forth(const scene::Camera& camera);
    void clear();

private:
    using Cameras = std::vector<scene::Camera>;
    std::optional<scene::Camera> step(const scene::Camera& camera, Cameras& from, Cameras& to);

    Cameras m_past;
    Cameras m_future;
    bool m_isMoving = false;
};

}  // namespace chiaro::widgets
