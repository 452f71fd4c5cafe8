#include "app/cli/demo/studio_set.h"

#include "core/base/resources.h"
#include "core/scene/mesh_io.h"

#include <algorithm>

namespace chiaro::cli::demo {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> sortedFiles(const fs::path& folder, const std::string& without) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().extension() != without) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

}  // namespace

StudioSet::StudioSet(std::uint64_t seed)
    : m_seed(seed),
      m_meshes(sortedFiles(resourceFolder() / "demo" / "meshes", ".md")),
      m_samples(sortedFiles(resourceFolder() / "demo" / "samples", ".md")) {}

const project::Paint& StudioSet::paint(const fs::path& sample, const Task& task) {
    if (const auto made = m_paints.find(sample); made != m_paints.end()) return made->second;
    project::Sample settings;
    settings.name = sample.stem().string();
    settings.scan = sample;
    synthesis::LevelParams params;
    params.quilt.seed = m_seed;
    return m_paints[sample] = project::preparePaint(settings, params, task);
}

const StudioSet::View& StudioSet::view(const fs::path& mesh, int side) {
    if (const auto made = m_views.find(mesh); made != m_views.end() && made->second.gbuffer.width == side)
        return made->second;
    View& view = m_views[mesh];
    view.project.meshes = {{mesh}};
    project::MeshList meshes;
    for (scene::Mesh& one : scene::readModel(mesh).meshes)
        meshes.push_back(std::make_shared<const scene::Mesh>(std::move(one)));
    view.scene = project::makeScene(view.project, {meshes});
    view.gbuffer = scene::castGBuffer(scene::RayScene(view.scene), view.scene.lights,
                                      project::cameraFor(view.project, view.scene), side, side);
    return view;
}

ColorAlphaImage StudioSet::painted(const fs::path& mesh, const fs::path& sample, int side, const Task& task) {
    const View& shown = view(mesh, side);
    const project::WornPaints worn(shown.scene.objects.size(), {&paint(sample, task)});
    return project::renderFrame(shown.project, worn, shown.gbuffer, task).frame.picture;
}

}  // namespace chiaro::cli::demo
