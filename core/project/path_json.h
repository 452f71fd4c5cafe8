#pragma once

#include "core/project/json_reader.h"
#include "core/scene/path.h"

namespace chiaro::project {

/// The members of a path: {"interpolation": "smooth" or "linear", "camera-turn": degrees a frame,
/// "light-turn": degrees a frame, "keys": [{"frame": 1, "azimuth": 30, "elevation": 15, "distance": 1,
/// "field-of-view": 30, "target": [x, y, z], "light": [x, y, z]}, ..]}, each key with any of these, frames
/// rising. Throws Error naming what is wrong.
scene::Path pathFromJson(const JsonReader& reader);
/// Writes what pathFromJson reads; turns of 0 are left out.
Json jsonFromPath(const scene::Path& path);

}  // namespace chiaro::project
