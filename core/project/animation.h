#pragma once

#include "core/methods/carried_texture.h"
#include "core/project/pipeline.h"
#include "core/scene/path.h"

#include <list>

namespace chiaro::project {

/// A moving view of a project's scene, ready to be painted. What is referred to must stay.
struct Shot {
    const Project& project;
    const scene::Scene& scene;
    const WornPaints& worn;  ///< [k - 1] of object k
    scene::Path path;
    int width = 0;  ///< of every frame, pixels
    int height = 0;

    /// The eye and the lights of a frame; frame 1 begins the path.
    scene::View view(int frame) const;
};

/// Names everything that a shot's pictures depend on but the parameters of its method: meshes, paints,
/// places, views. Two shots with the same name and parameters make the same frames.
std::uint64_t contentHash(const Shot& shot);

/// The views of a shot's frames as they are asked for; those asked for lately are kept, up to a bound of
/// memory.
class ShotViews {
public:
    explicit ShotViews(const Shot& shot, const Task& task = {});
    methods::FrameView at(int frame, const Task& task = {});

private:
    struct Kept {
        int frame;
        methods::FrameView view;
        std::size_t bytes;
    };
    const Shot& m_shot;
    scene::RayScene m_rays;
    std::list<Kept> m_kept;  ///< the latest first
};

/// Paints the frames of a shot by one method. A frame is the same whatever was painted before it, so that
/// parts of a shot may be painted apart.
class FramePainter {
public:
    virtual ~FramePainter() = default;
    /// Frame 1 or later. Throws Error, Cancelled.
    virtual Rendering paint(int frame, const Task& task) = 0;
};

/// The painter of the project's method; shot and views must stay. Throws Error.
std::unique_ptr<FramePainter> framePainter(const Shot& shot, ShotViews& views);

/// A path from a JSON file: {"path": 1, "interpolation": "smooth" or "linear", "keys": [{"frame": 1,
/// "azimuth": 30, "elevation": 15, "distance": 1, "field-of-view": 30, "target": [x, y, z], "light": [x, y,
/// z]}, ..]}, each key with any of these. Throws Error naming the file and what in it is wrong.
scene::Path readPath(const std::filesystem::path& file);

}  // namespace chiaro::project
