#include "app/cli/project_source.h"
#include "app/cli/sheet.h"
#include "core/base/atomic_file.h"
#include "core/base/resources.h"
#include "core/scene/mesh_io.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <memory>

namespace chiaro::cli {

namespace fs = std::filesystem;

namespace {

constexpr int side = 768;

/// A picture of the page and what is said below it.
struct Plate {
    std::string file;
    std::string caption;
};

std::vector<fs::path> sortedFiles(const fs::path& folder, const std::string& without) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().extension() != without) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string page(const std::vector<Plate>& plates) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Chiaro: the demo</title>\n"
        "<style>body{font:16px/1.5 sans-serif;background:#f6f3ec;color:#222;margin:2rem "
        "auto;max-width:1200px}\n"
        "main{display:grid;grid-template-columns:repeat(auto-fill,minmax(360px,1fr));gap:1.5rem}\n"
        "figure{margin:0}img{width:100%}figcaption{color:#555}</style></head>\n"
        "<body><h1>Chiaro: the demo</h1>\n<main>\n";
    for (const Plate& plate : plates)
        html += fmt::format("<figure><img src=\"{0}\" alt=\"{1}\"><figcaption>{1}</figcaption></figure>\n",
                            plate.file, plate.caption);
    return html + "</main></body></html>\n";
}

/// The demo project, each of its meshes with each of its samples, and the level stacks behind them.
class Demo {
public:
    Demo(fs::path folder, Session& session) : m_folder(std::move(folder)), m_session(session) {}

    void run() {
        m_session.start();
        const fs::path resources = resourceFolder() / "demo";
        const std::vector<fs::path> meshes = sortedFiles(resources / "meshes", ".md");
        const std::vector<fs::path> samples = sortedFiles(resources / "samples", ".md");
        const Task task = m_session.task("demo");
        Task::Steps steps(task, 1 + samples.size() + meshes.size() * samples.size());
        paintProject(resources / "demo.chiaro");
        steps.done();
        std::vector<project::Paint> paints;
        for (const fs::path& sample : samples) {
            paints.push_back(paintLevels(sample));
            steps.done();
        }
        for (const fs::path& mesh : meshes) {
            const View view = viewOf(mesh);
            for (std::size_t i = 0; i < samples.size(); ++i) {
                paintMesh(view, mesh, samples[i], paints[i]);
                steps.done();
            }
        }
        writeFileAtomically(m_folder / "index.html", page(m_plates));
        m_session.finish(
            {{"pictures", m_plates.size()}, {"folder", m_folder.string()}},
            fmt::format("{} pictures in {}; open index.html there", m_plates.size(), m_folder.string()));
    }

private:
    struct View {
        project::Project project;
        scene::Scene scene;
        scene::GBuffer gbuffer;
    };

    void add(const std::string& file, const std::string& caption, const ColorImage& picture) {
        writeImage(m_folder / file, picture,
                   pictureMetadata("demo", {{"picture", caption}, {"seed", m_session.flags.seed}}));
        m_plates.push_back({file, caption});
    }

    void paintProject(const fs::path& path) {
        project::Project project = project::readProject(path);
        project.levels.quilt.seed = m_session.flags.seed;
        const LoadedProject loaded = loadProject(std::move(project), m_session.task("project"));
        const scene::RayScene rays(loaded.scene);
        const scene::GBuffer gbuffer = scene::castGBuffer(
            rays, loaded.scene.lights, project::cameraFor(loaded.project, loaded.scene), 1280, 960);
        const methods::Frame frame =
            project::renderFrame(loaded.project,
                                 project::wornPaints(loaded.project, loaded.scene, loaded.paints), gbuffer)
                .frame;
        add("demo.png", "The demo project: every object in a paint of its own",
            methods::over(frame.picture, glm::vec3(1)));
    }

    project::Paint paintLevels(const fs::path& sample) {
        project::Sample settings;
        settings.name = sample.stem().string();
        settings.scan = sample;
        synthesis::LevelParams params;
        params.quilt.seed = m_session.flags.seed;
        project::Paint paint = project::preparePaint(settings, params);
        add(fmt::format("levels-{}.png", settings.name),
            fmt::format("{}: eight levels, each tiled twice", settings.name),
            levelSheet(paint.levels, paint.shown));
        return paint;
    }

    static View viewOf(const fs::path& mesh) {
        View view;
        view.project.meshes = {{mesh}};
        project::MeshList meshes;
        for (const scene::Mesh& one : scene::readModel(mesh).meshes)
            meshes.push_back(std::make_shared<const scene::Mesh>(one));
        view.scene = project::makeScene(view.project, {meshes});
        view.gbuffer = scene::castGBuffer(scene::RayScene(view.scene), view.scene.lights,
                                          project::cameraFor(view.project, view.scene), side, side);
        return view;
    }

    void paintMesh(const View& view, const fs::path& mesh, const fs::path& sample,
                   const project::Paint& paint) {
        const project::WornPaints worn(view.scene.objects.size(), {&paint});
        const methods::Frame frame = project::renderFrame(view.project, worn, view.gbuffer).frame;
        add(fmt::format("{}-{}.png", mesh.stem().string(), sample.stem().string()),
            fmt::format("{} in {}", mesh.stem().string(), sample.stem().string()),
            methods::over(frame.picture, glm::vec3(1)));
    }

    fs::path m_folder;
    Session& m_session;
    std::vector<Plate> m_plates;
};

}  // namespace

void addDemoCommand(CLI::App& root, Session& session) {
    CLI::App* command = root.add_subcommand("demo", "Paint the built-in scene; a page index.html shows it");
    auto folder = std::make_shared<fs::path>();
    command->add_option("-o,--output", *folder, "Folder for the pictures and index.html")->required();
    session.addCommonFlags(*command);
    command->callback([folder, &session] { Demo(*folder, session).run(); });
}

}  // namespace chiaro::cli
