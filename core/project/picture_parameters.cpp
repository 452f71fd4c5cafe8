#include "core/project/picture_parameters.h"

#include "core/project/render_method.h"

#include <nlohmann/json.hpp>

namespace chiaro::project {

nlohmann::json paintParameters(const Project& project) {
    nlohmann::json json{{"method", project.method}};
    for (const Sample& sample : project.samples) json["samples"].push_back(sample.scan.filename().string());
    json.update(renderMethod(project.method).parameters(project));
    return json;
}

nlohmann::json sceneParameters(const Project& project) {
    nlohmann::json json{
        {"camera", {project.camera.azimuth, project.camera.elevation, project.camera.distance}}};
    for (const MeshFile& mesh : project.meshes) json["meshes"].push_back(mesh.path.filename().string());
    json.update(parametersToJson(project.occlusion));
    for (const scene::Light& light : project.lights)
        json["lights"].push_back({light.vector.x, light.vector.y, light.vector.z, light.intensity});
    return json;
}

}  // namespace chiaro::project
