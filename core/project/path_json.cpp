#include "core/project/path_json.h"

#include "core/project/json_writer.h"

#include <map>

namespace chiaro::project {

namespace {

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
}

using Keys = std::map<int, Json>;

void writeChannel(const char* name, const scene::Channel& channel, Keys& keys) {
    for (const scene::Channel::Key& key : channel.keys) keys[int(key.frame)][name] = tidy(float(key.value));
}

void writeChannels(const char* name, const std::array<scene::Channel, 3>& channels, Keys& keys) {
    for (std::size_t i = 0; i < channels[0].keys.size(); ++i) {
        Json& vector = keys[int(channels[0].keys[i].frame)][name] = Json::array();
        for (const scene::Channel& axis : channels) vector.push_back(tidy(float(axis.keys[i].value)));
    }
}

}  // namespace

scene::Path pathFromJson(const JsonReader& reader) {
    scene::Path path;
    const std::string interpolation = reader.has("interpolation") ? reader.text("interpolation") : "smooth";
    if (interpolation != "smooth" && interpolation != "linear")
        throw reader.wrong("interpolation", "\"smooth\" or \"linear\"");
    path.smooth = interpolation == "smooth";
    reader.read("camera-turn", path.cameraTurn, -360, 360);
    reader.read("light-turn", path.lightTurn, -360, 360);
    reader.read("approach", path.approach, 0.01, 100);
    if (!reader.has("keys")) return path;
    int last = 0;
    for (const JsonReader& key : reader.children("keys")) {
        int frame = 0;
        key.at("frame");
        key.read("frame", frame, 1, lastFrame);
        if (frame <= last) throw key.wrong("frame", "keys in the order of their frames, each once");
        addKeys(key, frame, path);
        last = frame;
    }
    return path;
}

Json jsonFromPath(const scene::Path& path) {
    Json json{{"interpolation", path.smooth ? "smooth" : "linear"}};
    if (path.cameraTurn != 0) json["camera-turn"] = path.cameraTurn;
    if (path.lightTurn != 0) json["light-turn"] = path.lightTurn;
    if (path.approach != 1) json["approach"] = path.approach;
    Keys keys;
    writeChannel("azimuth", path.azimuth, keys);
    writeChannel("elevation", path.elevation, keys);
    writeChannel("distance", path.distance, keys);
    writeChannel("field-of-view", path.fieldOfView, keys);
    writeChannels("target", path.target, keys);
    writeChannels("light", path.light, keys);
    for (const auto& [frame, values] : keys) {
        Json key{{"frame", frame}};
        key.update(values);
        json["keys"].push_back(std::move(key));
    }
    return json;
}

}  // namespace chiaro::project
