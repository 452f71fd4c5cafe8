#pragma once

#include "core/scene/scene.h"

#include <array>
#include <vector>

namespace chiaro::scene {

/// The eye and the lights of one frame.
struct View {
    Camera camera;
    std::vector<Light> lights;
};

/// A value that changes with the frame: keys, and between them a monotone cubic (no overshoot) or straight
/// lines; before the first and after the last key it rests. Without keys it leaves things alone.
struct Channel {
    struct Key {
        double frame = 1;
        double value = 0;
        friend bool operator==(const Key&, const Key&) = default;
    };
    std::vector<Key> keys;  ///< frames strictly rising
    bool empty() const { return keys.empty(); }
    /// The value at any frame; there must be a key.
    double at(double frame, bool smooth) const;
    friend bool operator==(const Channel&, const Channel&) = default;
};

/// What moves in an animation, from a view that a project gives. A plain value, defined at every frame; frame
/// 1 of a turn is the view itself, so that parts of an animation fit together.
struct Path {
    double cameraTurn = 0;  ///< degrees a frame by which the camera goes around its target (a turntable)
    double lightTurn = 0;   ///< degrees a frame by which the lights go around +Y (a light sweep)
    double approach = 1;    ///< factor a frame by which the camera's distance changes; it stays in 0.01..100
    bool smooth = true;     ///< how channels pass from key to key
    Channel azimuth, elevation, distance, fieldOfView;  ///< of the camera, as scene::Camera has them
    std::array<Channel, 3> target;                      ///< of the camera, x, y, z
    std::array<Channel, 3> light;                       ///< the first light's vector, x, y, z
    friend bool operator==(const Path&, const Path&) = default;

    /// Once around in this many frames.
    static Path turntable(int period);
    static Path lightSweep(int period);
    /// The camera comes nearer by 4% of its distance from frame to frame.
    static Path approaching();

    /// The view at a frame of an animation that starts from this one.
    View at(double frame, const View& start) const;
};

}  // namespace chiaro::scene
