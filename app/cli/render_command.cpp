#include "app/cli/guide_source.h"
#include "app/cli/picture_output.h"
#include "app/cli/project_source.h"
#include "core/base/error.h"
#include "core/project/render_method.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <memory>
#include <set>

namespace chiaro::cli {

namespace {

struct Seconds {
    double load = 0;
    double guide = 0;
    double synthesis = 0;
    double shade = 0;
    double total() const { return load + guide + synthesis + shade; }
};

/// A view ready to be painted.
struct View {
    project::Project project;
    std::vector<project::Paint> paints;
    project::WornPaints worn;
    scene::GBuffer gbuffer;
};

double levelSeconds(const std::vector<project::Paint>& paints) {
    double seconds = 0;
    for (const project::Paint& paint : paints) seconds += paint.levelSeconds;
    return seconds;
}

struct RenderCommand {
    ProjectSource source;
    GuideSource guide;
    std::filesystem::path output;
    PictureOutput picture;

    void run(Session& session) const {
        session.start();
        picture.check();
        if (!isWritableImage(output))
            throw Error(output.string(), "has no extension of a picture", "choose .png, .exr or .tif");
        const Task task = session.task("render");
        Seconds seconds;
        const View view = guide.given() ? guideView(task, seconds) : meshView(task, seconds);
        Stopwatch stopwatch;
        const project::Rendering rendering =
            project::renderFrame(view.project, view.worn, view.gbuffer, task.part(0.7, 1));
        seconds.synthesis += rendering.synthesisSeconds;
        seconds.shade = stopwatch.lap() - rendering.synthesisSeconds;
        const ImageMetadata metadata = pictureMetadata("render", parameters(view));
        exporting::writePainted(output, rendering.frame.picture, picture.background(), metadata);
        if (picture.auxiliary().isGiven()) picture.auxiliary().write(view.gbuffer, rendering.frame, metadata);
        report(session, view, rendering.report, seconds);
    }

    /// The project for this subject, once it is sure that the picture replaces none of what it is made from.
    project::Project loadProjectFor(ProjectSource::Subject subject) const {
        project::Project project = source.load(subject);
        std::vector<std::filesystem::path> inputs = guide.inputs();
        inputs.push_back(source.path());
        for (const project::MeshFile& mesh : project.meshes) inputs.push_back(mesh.path);
        for (const project::Sample& sample : project.samples) inputs.push_back(sample.scan);
        refuseOverwriting(inputs, {output});
        return project;
    }

    View meshView(const Task& task, Seconds& seconds) const {
        Stopwatch stopwatch;
        LoadedProject loaded = loadProject(loadProjectFor(ProjectSource::Subject::Mesh), task.part(0, 0.5));
        seconds.synthesis = levelSeconds(loaded.paints);
        seconds.load = stopwatch.lap() - seconds.synthesis;
        const scene::RayScene rays(loaded.scene, task.part(0.5, 0.55));
        const scene::Camera camera = project::cameraFor(loaded.project, loaded.scene);
        View view{std::move(loaded.project), std::move(loaded.paints), {}, {}};
        const project::TextureCache cache(project::TextureCache::standardFolder());
        view.worn = project::wornPaints(view.project, loaded.scene, view.paints, task.part(0.5, 0.6), &cache);
        seconds.synthesis += stopwatch.lap();
        const glm::ivec2 pixels = picture.size();
        view.gbuffer =
            scene::castGBuffer(rays, loaded.scene.lights, camera, pixels.x, pixels.y, task.part(0.55, 0.7));
        seconds.guide = stopwatch.lap();
        return view;
    }

    View guideView(const Task& task, Seconds& seconds) const {
        Stopwatch stopwatch;
        View view{loadProjectFor(ProjectSource::Subject::Guide), {}, {}, {}};
        if (!project::renderMethod(view.project.method).takesGuides) {
            if (source.methodGiven())
                throw CLI::ValidationError(
                    fmt::format("--guide: is not for {}, which needs a mesh; choose --method image-based",
                                view.project.method));
            view.project.method = "image-based";
        }
        view.gbuffer = guide.read();
        seconds.guide = stopwatch.lap();
        view.paints = preparePaints(view.project, task.part(0, 0.7));
        view.worn = guide.wornPaints(view.project, view.gbuffer, view.paints);
        seconds.synthesis = levelSeconds(view.paints);
        seconds.load = stopwatch.lap() - seconds.synthesis;
        return view;
    }

    nlohmann::json parameters(const View& view) const {
        const project::Project& project = view.project;
        nlohmann::json json = picture.parameters();
        json["size"] = {view.gbuffer.width, view.gbuffer.height};
        json.update(paintParameters(project));
        json.update(guide.given() ? guide.parameters() : sceneParameters(project));
        return json;
    }

    void report(Session& session, const View& view, const synthesis::QuiltReport& quilted,
                const Seconds& seconds) const {
        const scene::GBuffer& gbuffer = view.gbuffer;
        const std::span<const std::uint16_t> ids = gbuffer.objectId.pixels();
        const auto covered = ids.size() - std::size_t(std::count(ids.begin(), ids.end(), 0));
        std::size_t blocks = quilted.blocks;
        double error = quilted.overlapError * double(quilted.blocks);
        for (const project::Paint& paint : view.paints) {
            blocks += paint.levels.report.blocks;
            error += paint.levels.report.overlapError * double(paint.levels.report.blocks);
        }
        std::set<const methods::PaintedObject*> objects;
        for (const project::Worn& worn : view.worn)
            if (worn.views && objects.insert(worn.views.get()).second) {
                const synthesis::QuiltReport& made = worn.views->textures.report;
                blocks += made.blocks;
                error += made.overlapError * double(made.blocks);
            }
        const nlohmann::json json{{"method", view.project.method},
                                  {"width", gbuffer.width},
                                  {"height", gbuffer.height},
                                  {"pixels", covered},
                                  {"blocks", blocks},
                                  {"seconds",
                                   {{"load", seconds.load},
                                    {"guide", seconds.guide},
                                    {"synthesis", seconds.synthesis},
                                    {"shade", seconds.shade},
                                    {"total", seconds.total()}}},
                                  {"overlap_error", blocks > 0 ? error / double(blocks) : 0},
                                  {"threads", session.threads()}};
        session.finish(
            json, fmt::format("{}: {} x {} px, {} painted, {:.2f} s (synthesis {:.2f} s)", output.string(),
                              gbuffer.width, gbuffer.height, covered, seconds.total(), seconds.synthesis));
    }
};

}  // namespace

void addRenderCommand(CLI::App& root, Session& session) {
    CLI::App* command =
        root.add_subcommand("render", "Paint a mesh, or any picture of light, and write the picture (§4)");
    auto state = std::make_shared<RenderCommand>();
    state->source.addTo(*command);
    command->add_option("-o,--output", state->output, "Picture to write: .png, .exr (scene-linear) or .tif")
        ->required();
    state->picture.addTo(*command);
    state->guide.addTo(*command);
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli
