#include "core/base/error.h"
#include "core/project/animation.h"
#include "core/project/json_reader.h"

namespace chiaro::project {

namespace {

constexpr std::uintmax_t largestFile = 16 << 20;
constexpr int lastFrame = 1'000'000;

/// Adds a key to a channel where the file gives a value.
void addKey(const JsonReader& key, const char* name, int frame, double minimum, double maximum,
            scene::Channel& channel) {
    if (!key.has(name)) return;
    float value = 0;
    key.read(name, value, minimum, maximum);
    channel.keys.push_back({double(frame), double(value)});
}

void addKey(const JsonReader& key, const char* name, int frame, std::array<scene::Channel, 3>& channels) {
    if (!key.has(name)) return;
    glm::vec3 value(0);
    key.read(name, value);
    for (std::size_t axis = 0; axis < 3; ++axis)
        channels[axis].keys.push_back({double(frame), double(value[glm::length_t(axis)])});
}

void addKeys(const JsonReader& key, int frame, scene::Path& path) {
    addKey(key, "azimuth", frame, -1e6, 1e6, path.azimuth);
    addKey(key, "elevation", frame, -90, 90, path.elevation);
    addKey(key, "distance", frame, 0.01, 100, path.distance);
    addKey(key, "field-of-view", frame, 1, 120, path.fieldOfView);
    addKey(key, "target", frame, path.target);
    addKey(key, "light", frame, path.light);
    if (key.has("light")) {
        glm::vec3 light(0);
        key.read("light", light);
        if (glm::length(light) == 0) throw key.wrong("light", "a direction that is not zero");
    }
}

}  // namespace

scene::Path readPath(const std::filesystem::path& file) {
    const Json json = readJson(file, largestFile, "choose a path of camera and light keys");
    const JsonReader reader(json, file.string());
    int version = 0;
    reader.at("path");
    reader.read("path", version, 1, 1);
    scene::Path path;
    const std::string interpolation = reader.has("interpolation") ? reader.text("interpolation") : "smooth";
    if (interpolation != "smooth" && interpolation != "linear")
        throw reader.wrong("interpolation", "\"smooth\" or \"linear\"");
    path.smooth = interpolation == "smooth";
    int last = 0;
    for (const JsonReader& key : reader.children("keys")) {
        int frame = 0;
        key.at("frame");
        key.read("frame", frame, 1, lastFrame);
        if (frame <= last) throw key.wrong("frame", "keys in the order of their frames, each once");
        addKeys(key, frame, path);
        last = frame;
    }
    if (last == 0) throw reader.wrong("keys", "at least one key");
    return path;
}

}  // namespace chiaro::project
