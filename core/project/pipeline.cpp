#include "core/project/pipeline.h"

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/project/objects.h"
#include "core/project/render_method.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <unordered_map>
#include <unordered_set>

namespace chiaro::project {

gradient::Gradient shownGradient(const Sample& sample, const gradient::Separation& separation) {
    if (!sample.recoloring) return separation.gradient;
    return sample.recoloring->sampled(int(separation.gradient.size()));
}

Paint separatePaint(const Sample& sample, const Task& task) {
    Paint paint;
    paint.strip = sample::readStrip(sample.scan, sample.strip);
    task.checkpoint();
    paint.separation = gradient::separate(paint.strip, sample.gradient, task);
    paint.shown = shownGradient(sample, paint.separation);
    return paint;
}

Paint preparePaint(const Sample& sample, const synthesis::LevelParams& levels, const Task& task) {
    Paint paint = separatePaint(sample, task.part(0, 0.2));
    const auto begin = std::chrono::steady_clock::now();
    paint.levels = synthesis::makeLevels(paint.strip, paint.separation.gradient, levels, task.part(0.2, 1));
    paint.levelSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return paint;
}

Paint preparePaint(const Project& project, std::size_t sample, const Task& task) {
    if (!renderMethod(project.method).usesLevels) return separatePaint(project.samples[sample], task);
    return preparePaint(project.samples[sample], project.levels, task);
}

namespace {

constexpr std::size_t maximumObjects = 65535;  // object ids have 16 bits

/// The meshes of a file by their names; of several with the same the first.
using NamedMeshes = std::unordered_map<std::string_view, std::shared_ptr<const scene::Mesh>>;

NamedMeshes byName(const MeshList& model) {
    NamedMeshes named;
    for (const auto& mesh : model) named.emplace(mesh->name, mesh);
    return named;
}

glm::mat4 placeOf(const ObjectSettings& settings, const scene::Mesh* mesh) {
    if (settings.placement == scene::Placement{} || !mesh) return settings.transform;
    const glm::vec3 centre(settings.transform * glm::vec4(centreOf(*mesh), 1));
    return settings.placement.matrix(centre) * settings.transform;
}

}  // namespace

scene::Scene makeScene(const Project& project, const std::vector<MeshList>& models) {
    ObjectNames names;
    std::vector<NamedMeshes> meshes;
    for (const MeshList& model : models) {
        meshes.push_back(byName(model));
        auto& ofFile = names.emplace_back();
        for (const auto& mesh : model) ofFile.push_back(mesh->name);
    }
    scene::Scene scene;
    scene.lights = project.lights;
    scene.occlusion = project.occlusion;
    for (const ObjectSettings& settings : allObjects(project, names)) {
        scene::Object& object = scene.objects.emplace_back();
        object.name = settings.name;
        if (std::size_t(settings.mesh) < meshes.size()) {
            const NamedMeshes& ofFile = meshes[std::size_t(settings.mesh)];
            const auto found = ofFile.find(settings.sourceName());
            if (found != ofFile.end()) object.mesh = found->second;
        }
        object.transform = placeOf(settings, object.mesh.get());
        object.sample = settings.sample;
        object.visible = settings.visible;
    }
    if (scene.objects.size() > maximumObjects)
        throw Error("the scene", fmt::format("has {} objects", scene.objects.size()),
                    fmt::format("at most {} are painted", maximumObjects));
    return scene;
}

scene::Camera cameraFor(const Project& project, const scene::Scene& scene) {
    return project.frameCamera ? project.camera.framed(boundsOf(scene)) : project.camera;
}

double scaleOf(const scene::Object& object) {
    return std::cbrt(std::abs(double(glm::determinant(glm::mat3(object.transform)))));
}

namespace {

int mapSizeOf(const scene::Scene& scene, std::size_t object, int largestMap) {
    constexpr int smallestMap = 64;
    const auto sizeOf = [](const scene::Object& one) {
        return one.mesh ? scaleOf(one) * double(boundsOf(*one.mesh).radius) : 0.0;
    };
    double largest = 0;
    for (const scene::Object& one : scene.objects) largest = std::max(largest, sizeOf(one));
    if (!(largest > 0)) return largestMap;
    const double share = sizeOf(scene.objects[object]) / largest;
    return std::clamp(int(std::lround(share * largestMap)), std::min(smallestMap, largestMap), largestMap);
}

}  // namespace

std::shared_ptr<const methods::PlannedObject> planObject(const Project& project, const scene::Scene& scene,
                                                         std::size_t object, const Task& task) {
    std::vector<views::View> kept;
    const auto settings =
        std::ranges::find(project.objects, scene.objects[object].name, &ObjectSettings::name);
    if (settings != project.objects.end())
        for (const PlacedView& placed : settings->views) {
            views::View& view = kept.emplace_back();
            view.name = fmt::format("View {}", kept.size());
            view.direction = glm::dvec3(placed.direction);
            view.up = glm::dvec3(placed.up);
            view.projection = project.views.projection;
            view.locked = true;
        }
    views::ViewParams params = project.views;
    params.size = mapSizeOf(scene, object, params.size);
    return methods::planObject(scene.objects[object].mesh, params, kept, task);
}

namespace {

/// Raised whenever synthesizeViews makes other textures of the same: those kept on disk are then made again.
constexpr int textureRecipe = 2;

/// Names all that an object's textures are made from, the program that makes them included.
std::uint64_t texturesKey(const methods::PlannedObject& planned,
                          const std::vector<synthesis::LevelSource>& sources, bool propagate) {
    Hasher hasher;
    hasher.add(std::string_view(CHIARO_VERSION)).add(textureRecipe).add(propagate);
    const scene::Mesh& mesh = planned.surface.mesh();
    hasher.add(std::span(mesh.positions)).add(std::span(mesh.triangles));
    for (const views::FaceGroup& group : planned.plan.groups) {
        const views::View& view = group.view;
        for (const double value :
             {view.direction.x, view.direction.y, view.direction.z, view.up.x, view.up.y, view.up.z,
              view.fieldOfView, view.target.x, view.target.y, view.target.z, view.halfExtent})
            hasher.add(value);
        hasher.add(view.projection).add(view.size).add(std::span(group.faces));
    }
    for (const synthesis::LevelSource& source : sources) {
        hasher.add(source.texture.width()).add(source.texture.pixels());
        for (const double value : synthesis::QuiltParams::table().values(source.quilt)) hasher.add(value);
    }
    return hasher.value();
}

}  // namespace

std::shared_ptr<const methods::PaintedObject> paintObject(
    const Project& project, std::shared_ptr<const methods::PlannedObject> planned, const Paint& paint,
    const Task& task, const TextureCache* cache) {
    auto painted = std::make_shared<methods::PaintedObject>();
    painted->weights = std::make_shared<const methods::ViewWeights>(*planned, project.views.epsilon);
    const auto sources = synthesis::levelSources(paint.strip, paint.separation.gradient, project.levels);
    const std::uint64_t key = cache ? texturesKey(*planned, sources, project.viewDependent.propagate) : 0;
    std::optional<methods::ViewTextures> known;
    if (cache) known = cache->find(key);
    if (known && known->views.size() == planned->plan.groups.size()) {
        painted->textures = std::move(*known);
    } else {
        painted->textures =
            methods::synthesizeViews(*planned, sources, project.viewDependent.propagate, task);
        if (cache) cache->store(key, painted->textures);
    }
    painted->planned = std::move(planned);
    return painted;
}

namespace {

/// The names of the objects that the artist placed views on.
std::unordered_set<std::string_view> withPlacedViews(const Project& project) {
    std::unordered_set<std::string_view> names;
    for (const ObjectSettings& settings : project.objects)
        if (!settings.views.empty()) names.insert(settings.name);
    return names;
}

}  // namespace

WornPaints wornPaints(const Project& project, const scene::Scene& scene, const std::vector<Paint>& paints,
                      const Task& task, const TextureCache* cache) {
    WornPaints worn;
    const std::unordered_set<std::string_view> placed = withPlacedViews(project);
    const bool usesViews = renderMethod(project.method).usesViews;
    std::map<std::tuple<const scene::Mesh*, int, double>, std::shared_ptr<const methods::PaintedObject>>
        painted;
    const double share = 1 / double(std::max<std::size_t>(scene.objects.size(), 1));
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object& object = scene.objects[i];
        Worn& one = worn.emplace_back(
            Worn{&paints[std::size_t(object.sample)], nullptr, glm::inverse(object.transform)});
        if (!usesViews || !object.visible || !object.mesh) continue;
        // A copy of an object wears its textures, unless the artist placed views on either.
        std::shared_ptr<const methods::PaintedObject> own;
        auto& views =
            placed.contains(object.name) ? own : painted[{object.mesh.get(), object.sample, scaleOf(object)}];
        if (!views) {
            const Task part = task.part(share * double(i), share * double(i + 1));
            views = paintObject(project, planObject(project, scene, i, part.part(0, 0.2)), *one.paint,
                                part.part(0.2, 1), cache);
        }
        one.views = views;
    }
    return worn;
}

Rendering renderFrame(const Project& project, const WornPaints& worn, const scene::GBuffer& gbuffer,
                      const Task& task) {
    return renderMethod(project.method).render(project, worn, gbuffer, task);
}

}  // namespace chiaro::project
