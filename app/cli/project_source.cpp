#include "app/cli/project_source.h"

#include "core/base/error.h"
#include "core/project/objects.h"
#include "core/project/render_method.h"
#include "core/scene/mesh_io.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <unordered_set>

namespace chiaro::cli {

namespace {

project::Sample sampleFrom(const std::filesystem::path& scan) {
    project::Sample sample;
    sample.name = scan.stem().string();
    sample.scan = scan;
    return sample;
}

/// Of an object that --object names and the project doesn't: whichever mesh file has it.
constexpr int anyFile = -1;

/// `NAME=SAMPLE`: gives one object a sample of its own.
void dress(project::Project& project, const std::string& assignment) {
    const std::size_t equals = assignment.rfind('=');
    project.samples.push_back(sampleFrom(assignment.substr(equals + 1)));
    const std::string name = assignment.substr(0, equals);
    auto object = std::find_if(project.objects.begin(), project.objects.end(),
                               [&](const project::ObjectSettings& one) { return one.name == name; });
    if (object == project.objects.end())
        object = project.objects.insert(object, project::ObjectSettings{.name = name, .mesh = anyFile});
    object->sample = int(project.samples.size()) - 1;
}

Error unknownObject(const std::filesystem::path& file, const std::string& wanted,
                    const std::vector<std::string>& names) {
    return Error(file.string(), "has no object \"" + wanted + "\"",
                 fmt::format("it has \"{}\"", fmt::join(names, "\", \"")).substr(0, 400));
}

/// Reads a project's mesh file and refuses the project when it names objects that the file doesn't have.
project::MeshList readMeshes(const project::Project& project, std::size_t file, const Task& task) {
    const std::filesystem::path& path = project.meshes[file].path;
    project::MeshList meshes;
    std::vector<std::string> names;
    for (scene::Mesh& mesh : scene::readModel(path, task).meshes) {
        names.push_back(mesh.name);
        meshes.push_back(std::make_shared<const scene::Mesh>(std::move(mesh)));
    }
    const std::unordered_set<std::string> known(names.begin(), names.end());
    for (const project::ObjectSettings& object : project.objects)
        if (object.mesh == int(file) && !known.contains(object.sourceName()))
            throw unknownObject(path, object.sourceName(), names);
    return meshes;
}

/// The project with the objects that --object named where the scene has them, by the names that it gives
/// them.
project::Project withAllObjects(const project::Project& project,
                                const std::vector<project::MeshList>& models) {
    project::Project found = project;
    const auto isPlaceless = [](const project::ObjectSettings& object) { return object.mesh == anyFile; };
    if (std::erase_if(found.objects, isPlaceless) == 0) return found;
    project::ObjectNames names;
    for (const project::MeshList& model : models) {
        names.emplace_back();
        for (const auto& mesh : model) names.back().push_back(mesh->name);
    }
    found.objects = project::allObjects(found, names);
    for (const project::ObjectSettings& wanted : project.objects) {
        if (!isPlaceless(wanted)) continue;
        const auto object = std::ranges::find(found.objects, wanted.name, &project::ObjectSettings::name);
        if (object != found.objects.end()) {
            object->sample = wanted.sample;
            continue;
        }
        std::vector<std::string> known;
        for (const project::ObjectSettings& one : found.objects) known.push_back(one.name);
        throw unknownObject(project.meshes.size() == 1 ? project.meshes.front().path : "the scene",
                            wanted.name, known);
    }
    return found;
}

}  // namespace

void ProjectSource::addTo(CLI::App& command) {
    command.add_option("PROJECT", m_path, "Project, a .chiaro file; flags override what it says");
    addSceneFlags(command);
    addMethodFlags(command);
}

void ProjectSource::addSceneFlags(CLI::App& command) {
    const auto overrides = [this](auto apply) {
        return [this, apply](const std::string& text) {
            m_overrides.push_back([apply, text](project::Project& project) { apply(project, text); });
        };
    };
    command.add_option_function<std::string>(
        "--mesh", overrides([](project::Project& project, const std::string& text) {
            project.meshes = {{text}};
            project.objects.clear();
            project.frameCamera = true;
        }),
        "Mesh to paint in place of the project's: OBJ, PLY, OFF, STL, GLB or glTF");
    addOverrides<scene::OcclusionParams>(
        command, {[](project::Project& project) -> scene::OcclusionParams& { return project.occlusion; }});
    command.add_option_function<std::string>(
        "--sample", overrides([](project::Project& project, const std::string& text) {
            project.samples = {sampleFrom(text)};
            for (project::ObjectSettings& object : project.objects) object.sample = 0;
        }),
        "Paint sample that every object wears");
    command
        .add_option_function<std::vector<std::string>>(
            "--object",
            [this](const std::vector<std::string>& assignments) {
                for (const std::string& assignment : assignments)
                    m_overrides.push_back(
                        [assignment](project::Project& project) { dress(project, assignment); });
            },
            "NAME=SAMPLE: the object of this name wears another sample; may be repeated")
        ->check([](const std::string& text) {
            return text.find('=') == std::string::npos ? "is \"" + text + "\"; write NAME=SAMPLE"
                                                       : std::string();
        });
    command.add_option_function<std::string>(
        "--light",
        [this](const std::string& text) {
            const std::vector<float> v = numbersFrom("--light", text, 3);
            const glm::vec3 vector(v[0], v[1], v[2]);
            if (glm::length(vector) == 0)
                throw CLI::ValidationError("--light: is 0,0,0; write a direction that is not zero");
            m_overrides.push_back([vector](project::Project& project) {
                project.lights = {scene::Light{}};
                project.lights.front().vector = vector;
            });
        },
        "x,y,z: direction from the surface towards the light, world space (default -0.5,0.7,0.6)");
    command.add_option_function<std::string>(
        "--camera",
        [this](const std::string& text) {
            const std::vector<float> v = numbersFrom("--camera", text, 3);
            if (std::abs(v[1]) > 90)
                throw CLI::ValidationError(fmt::format("--camera: elevation is {:g}; choose -90..90", v[1]));
            if (v[2] < 0.01f || v[2] > 100)
                throw CLI::ValidationError(fmt::format("--camera: distance is {:g}; choose 0.01..100", v[2]));
            m_overrides.push_back([v](project::Project& project) {
                project.camera.azimuth = v[0];
                project.camera.elevation = v[1];
                project.camera.distance = v[2];
            });
        },
        "azimuth,elevation,distance: degrees around +Y from +Z, degrees above the horizon, and the distance "
        "in units of "
        "that from which the scene just fills the picture (default 30,15,1)");
}

template <class Params>
void ProjectSource::addOverrides(CLI::App& command, std::vector<Params& (*)(project::Project&)> members,
                                 const std::string& prefix) {
    const ParameterTable<Params>& table = Params::table();
    addParameterFlags(
        command, table.specs(), table.values(Params()),
        [this, members, &table](std::size_t index, double value) {
            m_overrides.push_back([members, &table, index, value](project::Project& project) {
                for (const auto member : members) {
                    std::vector<double> values = table.values(member(project));
                    values[index] = value;
                    table.assign(member(project), values);
                }
            });
        },
        prefix);
}

void ProjectSource::addMethodFlags(CLI::App& command) {
    using project::Project;
    std::vector<std::string> keys;
    for (const project::RenderMethod& method : project::renderMethods()) keys.push_back(method.key);
    command
        .add_option_function<std::string>(
            "--method",
            [this](const std::string& method) {
                m_methodGiven = true;
                m_overrides.push_back([method](Project& project) { project.method = method; });
            },
            fmt::format("How the paint is laid on ({}; default {})", fmt::join(keys, ", "), Project().method))
        ->check(CLI::IsMember(keys));
    addOverrides<methods::ViewAlignedParams>(
        command, {[](Project& project) -> methods::ViewAlignedParams& { return project.viewAligned; }});
    addOverrides<methods::ImageBasedParams>(
        command, {[](Project& project) -> methods::ImageBasedParams& { return project.imageBased; }});
    addOverrides<methods::ViewDependentParams>(
        command, {[](Project& project) -> methods::ViewDependentParams& { return project.viewDependent; }});
    addOverrides<views::ViewParams>(
        command, {[](Project& project) -> views::ViewParams& { return project.views; }}, "view-");
    addOverrides<synthesis::LevelParams>(
        command, {[](Project& project) -> synthesis::LevelParams& { return project.levels; }}, "level-");
    // One set of flags for whichever method quilts.
    addOverrides<synthesis::QuiltParams>(
        command, {[](Project& project) -> synthesis::QuiltParams& { return project.levels.quilt; },
                  [](Project& project) -> synthesis::QuiltParams& { return project.imageBased.quilt; }});
}

project::Project ProjectSource::load(Subject subject) const {
    project::Project project;
    if (!m_path.empty()) project = project::readProject(m_path);
    if (subject == Subject::Guide) project.objects.clear();
    for (const Override& apply : m_overrides) apply(project);
    if (subject == Subject::Mesh && project.meshes.empty())
        throw CLI::ValidationError("no mesh is given; name a project or --mesh FILE");
    if (project.samples.empty())
        throw CLI::ValidationError("no sample is given; name a project or --sample STRIP");
    return project;
}

std::vector<project::Paint> preparePaints(const project::Project& project, const Task& task) {
    std::vector<project::Paint> paints;
    const double share = 1 / double(project.samples.size());
    for (std::size_t i = 0; i < project.samples.size(); ++i)
        paints.push_back(
            project::preparePaint(project, i, task.part(share * double(i), share * double(i + 1))));
    return paints;
}

scene::Scene readScene(const project::Project& project, const Task& task) {
    std::vector<project::MeshList> models;
    const double share = 1 / double(project.meshes.size());
    for (std::size_t i = 0; i < project.meshes.size(); ++i)
        models.push_back(readMeshes(project, i, task.part(share * double(i), share * double(i + 1))));
    return project::makeScene(withAllObjects(project, models), models);
}

LoadedProject loadProject(project::Project project, const Task& task) {
    LoadedProject loaded{.project = std::move(project), .scene = {}, .paints = {}};
    loaded.scene = readScene(loaded.project, task.part(0, 0.2));
    loaded.paints = preparePaints(loaded.project, task.part(0.2, 1));
    return loaded;
}

glm::ivec2 sizeFrom(const std::string& flag, const std::string& text) {
    glm::ivec2 size(0);
    int read = 0;
    const int fields = std::sscanf(text.c_str(), "%dx%d%n", &size.x, &size.y, &read);
    constexpr std::int64_t most =
        64 << 20;  // pixels, which take about 75 bytes each until the picture is written
    const bool valid = fields == 2 && std::int64_t(size.x) * size.y <= most &&
                       std::size_t(read) == text.size() && size.x >= 1 && size.y >= 1 && size.x <= 16384 &&
                       size.y <= 16384;
    if (!valid)
        throw CLI::ValidationError(
            fmt::format("{}: is \"{}\"; write WIDTHxHEIGHT, each 1..16384 px and both at most 64 megapixels",
                        flag, text));
    return size;
}

}  // namespace chiaro::cli
