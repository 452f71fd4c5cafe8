#include "core/base/error.h"
#include "core/project/animation.h"
#include "core/project/path_json.h"

namespace chiaro::project {

namespace {

constexpr std::uintmax_t largestFile = 16 << 20;

}  // namespace

scene::Path readPath(const std::filesystem::path& file) {
    const Json json = readJson(file, largestFile, "choose a path of camera and light keys");
    const JsonReader reader(json, file.string());
    int version = 0;
    reader.at("path");
    reader.read("path", version, 1, 1);
    const scene::Path path = pathFromJson(reader);
    if (reader.at("keys").empty()) throw reader.wrong("keys", "at least one key");
    for (const JsonReader& key : reader.children("keys")) {
        glm::vec3 light(1);
        if (key.has("light")) key.read("light", light);
        if (light == glm::vec3(0)) throw key.wrong("light", "a direction that is not zero");
    }
    return path;
}

}  // namespace chiaro::project
