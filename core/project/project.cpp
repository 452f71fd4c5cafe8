#include "core/project/project.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/project/json_reader.h"
#include "core/project/json_writer.h"
#include "core/project/path_json.h"
#include "core/project/render_method.h"
#include "core/project/stage_json.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace chiaro::project {

namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t largestFile = 64 << 20;

Json jsonFromSample(const Sample& sample, const fs::path& folder) {
    Json json;
    json["name"] = sample.name;
    json["scan"] = sample.scan.lexically_proximate(folder).generic_string();
    json["strip"] = jsonFromParams(sample.strip);
    for (const glm::vec2& corner : sample.strip.crop) json["strip"]["crop"].push_back(jsonFromVector(corner));
    json["gradient"] = jsonFromParams(sample.gradient);
    for (const glm::vec2& point : sample.gradient.curve.points)
        json["gradient"]["curve"].push_back(jsonFromVector(point));
    if (sample.recoloring) json["recoloring"] = jsonFromColorPath(*sample.recoloring);
    return json;
}

Json jsonFromObject(const ObjectSettings& object) {
    Json json{{"name", object.name}};
    if (object.sourceName() != object.name) json["source"] = object.source;
    if (object.mesh != 0) json["mesh"] = object.mesh;
    json["sample"] = object.sample;
    json["visible"] = object.visible;
    const scene::Placement unmoved, &placement = object.placement;
    if (placement.position != unmoved.position) json["position"] = jsonFromVector(placement.position);
    if (placement.rotation != unmoved.rotation) json["rotation"] = jsonFromVector(placement.rotation);
    if (placement.scale != unmoved.scale) json["scale"] = jsonFromVector(placement.scale);
    if (!object.views.empty()) json["views"] = jsonFromPlacedViews(object.views);
    if (object.transform == glm::mat4(1)) return json;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) json["transform"].push_back(tidy(object.transform[column][row]));
    return json;
}

Json jsonFromMesh(const MeshFile& mesh, const fs::path& folder) {
    Json json{{"file", mesh.path.lexically_proximate(folder).generic_string()}};
    if (!mesh.without.empty()) json["without"] = mesh.without;
    return json;
}

Json jsonFromLight(const scene::Light& light) {
    Json json;
    if (!light.name.empty()) json["name"] = light.name;
    json["kind"] = light.kind == scene::Light::Kind::Point ? "point" : "directional";
    json["vector"] = jsonFromVector(light.vector);
    json["intensity"] = tidy(light.intensity);
    json["wrap"] = light.wrap;
    if (!light.visible) json["visible"] = false;
    return json;
}

Json jsonFromAnimation(const Animation& animation) {
    Json json{{"frames", animation.frames},
              {"range", {animation.firstFrame, animation.lastFrame}},
              {"rate", animation.rate}};
    json.update(jsonFromPath(animation.path));
    return json;
}

Json jsonFromCamera(const Project& project) {
    const scene::Camera& camera = project.camera;
    Json json{{"azimuth", tidy(camera.azimuth)},
              {"elevation", tidy(camera.elevation)},
              {"distance", tidy(camera.distance)},
              {"field-of-view", tidy(camera.fieldOfView)}};
    if (project.frameCamera) return json;
    json["target"] = jsonFromVector(camera.target);
    json["radius"] = tidy(camera.radius);
    return json;
}

Sample readSample(const JsonReader& reader, const fs::path& folder) {
    Sample sample;
    sample.name = reader.text("name");
    sample.scan = (folder / reader.text("scan")).lexically_normal();
    if (reader.has("strip")) {
        const JsonReader strip = reader.child("strip");
        strip.params(sample.strip);
        if (strip.has("crop")) {
            const std::vector<glm::vec2> corners = strip.points("crop");
            if (corners.size() != 4) throw strip.wrong("crop", "four corners");
            std::copy(corners.begin(), corners.end(), sample.strip.crop.begin());
        }
    }
    if (reader.has("gradient")) {
        const JsonReader gradient = reader.child("gradient");
        gradient.params(sample.gradient);
        if (gradient.has("curve")) {
            sample.gradient.curve.points = gradient.points("curve");
            sample.gradient.curve.sampled(2);  // refuses points that make no monotone curve
        }
    }
    if (reader.has("recoloring")) sample.recoloring = colorPathFromJson(reader.child("recoloring"));
    return sample;
}

void readPlacement(const JsonReader& reader, scene::Placement& placement) {
    reader.read("position", placement.position);
    reader.read("rotation", placement.rotation);
    reader.read("scale", placement.scale);
    const glm::vec3& scale = placement.scale;
    if (scale.x * scale.y * scale.z == 0) throw reader.wrong("scale", "numbers that are not zero");
}

ObjectSettings readObject(const JsonReader& reader, const Project& project) {
    ObjectSettings object;
    object.name = reader.text("name");
    if (reader.has("source")) object.source = reader.text("source");
    reader.read("mesh", object.mesh, 0, int(project.meshes.size()) - 1);
    reader.read("sample", object.sample, 0, int(project.samples.size()) - 1);
    reader.read("visible", object.visible);
    readPlacement(reader, object.placement);
    reader.read("transform", object.transform);
    if (reader.has("views")) object.views = placedViewsFromJson(reader, "views");
    return object;
}

std::vector<MeshFile> readMeshes(const JsonReader& reader, const fs::path& folder) {
    const auto located = [&](const std::string& file) { return (folder / file).lexically_normal(); };
    std::vector<MeshFile> meshes;
    if (reader.has("mesh")) meshes.push_back({located(reader.text("mesh"))});  // version 1
    if (!reader.has("meshes")) return meshes;
    for (const JsonReader& child : reader.children("meshes")) {
        MeshFile& mesh = meshes.emplace_back(MeshFile{located(child.text("file"))});
        if (child.has("without")) mesh.without = child.texts("without");
    }
    return meshes;
}

scene::Light readLight(const JsonReader& reader) {
    using Kind = scene::Light::Kind;
    scene::Light light;
    const std::string kind = reader.has("kind") ? reader.text("kind") : "directional";
    if (kind != "directional" && kind != "point") throw reader.wrong("kind", "\"directional\" or \"point\"");
    light.kind = kind == "point" ? Kind::Point : Kind::Directional;
    if (reader.has("name")) light.name = reader.text("name");
    reader.read("vector", light.vector);
    if (light.kind == Kind::Directional && glm::length(light.vector) == 0)
        throw reader.wrong("vector", "a direction that is not zero");
    reader.read("intensity", light.intensity, 0, 4);
    reader.read("wrap", light.wrap);
    reader.read("visible", light.visible);
    return light;
}

Animation readAnimation(const JsonReader& reader) {
    Animation animation;
    reader.read("frames", animation.frames, 1, 100'000);
    animation.lastFrame = animation.frames;
    if (reader.has("range")) {
        const std::vector<int> range = reader.integers("range", 1, animation.frames);
        if (range.size() != 2 || range[0] > range[1])
            throw reader.wrong("range", "the first and the last frame");
        animation.firstFrame = range[0];
        animation.lastFrame = range[1];
    }
    reader.read("rate", animation.rate, 1, 240);
    animation.path = pathFromJson(reader);
    return animation;
}

std::string readMethod(const JsonReader& reader) {
    const std::string key = reader.text("method");
    if (findRenderMethod(key)) return key;
    std::vector<std::string> keys;
    for (const RenderMethod& method : renderMethods()) keys.push_back("\"" + method.key + "\"");
    throw reader.wrong("method", fmt::format("{}", fmt::join(keys, " or ")));
}

void readCamera(const JsonReader& reader, Project& project) {
    scene::Camera& camera = project.camera;
    reader.read("azimuth", camera.azimuth, -1e6, 1e6);
    reader.read("elevation", camera.elevation, -90, 90);
    reader.read("distance", camera.distance, 0.01, 100);
    reader.read("field-of-view", camera.fieldOfView, 1, 120);
    project.frameCamera = !reader.has("target");
    reader.read("target", camera.target);
    reader.read("radius", camera.radius, 1e-9, 1e9);
}

int versionIn(const JsonReader& reader) {
    int version = 0;
    reader.at("chiaro");
    reader.read("chiaro", version, 1, 1 << 30);
    return version;
}

Error newerError(const fs::path& path, int version) {
    return Error(path.string(), fmt::format("was written by a newer Chiaro (format {})", version),
                 fmt::format("this one reads format {}", Project::version));
}

Project projectFromJson(const JsonReader& reader, const fs::path& path) {
    const fs::path folder = fs::absolute(path).parent_path();
    Project project;
    for (const JsonReader& sample : reader.children("samples"))
        project.samples.push_back(readSample(sample, folder));
    project.meshes = readMeshes(reader, folder);
    if (reader.has("objects"))
        for (const JsonReader& object : reader.children("objects"))
            project.objects.push_back(readObject(object, project));
    if (reader.has("lights")) {
        project.lights.clear();
        for (const JsonReader& light : reader.children("lights")) project.lights.push_back(readLight(light));
    }
    if (reader.has("occlusion")) reader.child("occlusion").params(project.occlusion);
    if (reader.has("animation")) project.animation = readAnimation(reader.child("animation"));
    if (reader.has("camera")) readCamera(reader.child("camera"), project);
    if (reader.has("method")) project.method = readMethod(reader);
    MethodParams params = MethodParams::of(project);
    readMethodParams(reader, params);
    params.applyTo(project);
    return project;
}

}  // namespace

MethodParams MethodParams::of(const Project& project) {
    return {project.levels,    project.viewAligned,   project.imageBased,
            project.coherence, project.viewDependent, project.views};
}

void MethodParams::applyTo(Project& project) const {
    project.levels = levels;
    project.viewAligned = viewAligned;
    project.imageBased = imageBased;
    project.coherence = coherence;
    project.viewDependent = viewDependent;
    project.views = views;
}

ProjectFile readProjectFile(const fs::path& path) {
    const Json json = readJson(path, largestFile, "choose a project that Chiaro saved");
    const JsonReader reader(json, path.string());
    const int version = versionIn(reader);
    try {
        return {projectFromJson(reader, path), version};
    } catch (const Error&) {
        if (version > Project::version) throw newerError(path, version);  // nothing is wrong with the file
        throw;
    }
}

Project readProject(const fs::path& path) {
    ProjectFile file = readProjectFile(path);
    if (file.isNewer()) throw newerError(path, file.version);
    return std::move(file.project);
}

void refuseToReplaceNewer(const fs::path& path) {
    int version = 0;
    try {
        const Json json = readJson(path, largestFile, {});
        version = versionIn(JsonReader(json, path.string()));
    } catch (const Error&) {
        return;  // no project is there
    }
    if (version > Project::version)
        throw Error(path.string(), fmt::format("was written by a newer Chiaro (format {})", version),
                    "save under another name, so that what only the newer one knows is not lost");
}

std::string projectText(const fs::path& path, const Project& project) {
    const fs::path folder = fs::absolute(path).parent_path();
    Json json;
    json["chiaro"] = Project::version;
    json["samples"] = Json::array();
    for (const Sample& sample : project.samples) json["samples"].push_back(jsonFromSample(sample, folder));
    for (const MeshFile& mesh : project.meshes) json["meshes"].push_back(jsonFromMesh(mesh, folder));
    for (const ObjectSettings& object : project.objects) json["objects"].push_back(jsonFromObject(object));
    json["lights"] = Json::array();
    for (const scene::Light& light : project.lights) json["lights"].push_back(jsonFromLight(light));
    json["occlusion"] = jsonFromParams(project.occlusion);
    if (project.animation != Animation{}) json["animation"] = jsonFromAnimation(project.animation);
    json["camera"] = jsonFromCamera(project);
    json["method"] = project.method;
    json.update(jsonFromMethodParams(MethodParams::of(project)));
    return json.dump(2) + "\n";
}

void writeProject(const fs::path& path, const Project& project) {
    writeFileAtomically(path, projectText(path, project));
}

}  // namespace chiaro::project
