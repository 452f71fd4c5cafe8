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
    void set(double frame, double value);
    void remove(double frame);
    /// The value at any frame; there must be a key.
    double at(double frame, bool smooth) const;
    friend bool operator==(const Channel&, const Channel&) = default;
};

/// What moves in an animation, from a view that a project gives. A plain value, defined at every frame; frame
/// 1 of a turn is the view itself, so that parts of an animation fit together.
struct Path {
    double cameraTurn = 0;  ///< degrees a frame by which the camera goes around its target (a turntable)
    double lightTurn = 0;   ///< degrees a frame by which the lights go around +Y (a light sweep), those at a
                            ///< point around the camera's target
    double approach = 1;    ///< factor a frame by which the camera's distance changes; it stays in 0.01..100
    bool smooth = true;     ///< how channels pass from key to key
    Channel azimuth, elevation, distance, fieldOfView;  ///< of the camera, as scene::Camera has them
    std::array<Channel, 3> target;                      ///< of the camera, x, y, z
    std::array<Channel, 3> light;                       ///< the first light's vector, x, y, z
    friend bool operator==(const Path&, const Path&) = default;

    /// What keys are set for.
    enum class Part { Camera, Light };
    /// The frames where some channel of the part has a key, rising.
    std::vector<int> keyFrames(Part part) const;
    /// Keys every channel of the camera, or the light's vector; a key that is there is replaced.
    void setKey(int frame, const Camera& camera);
    void setKey(int frame, glm::vec3 lightVector);
    void removeKey(Part part, int frame);
    /// A key that is there is replaced.
    void moveKey(Part part, int from, int to);

    /// Once around in this many frames.
    static Path turntable(int period);
    static Path lightSweep(int period);
    /// The camera comes nearer by 4% of its distance from frame to frame.
    static Path approaching();

    /// False when every frame is the view itself.
    bool moves() const;

    /// The view at a frame of an animation that starts from this one.
    View at(double frame, const View& start) const;

private:
    template <class Self>
    static auto channels(Self& self, Part part);
};

}  // namespace chiaro::scene
