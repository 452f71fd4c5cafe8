#include "app/cli/overwrite_flag.h"
#include "app/cli/project_source.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/export/relightable_page.h"
#include "core/project/mesh_export.h"
#include "core/project/page_export.h"
#include "core/project/render_method.h"

#include <spdlog/fmt/fmt.h>

#include <memory>

namespace chiaro::cli {

namespace {

struct ExportCommand {
    ProjectSource source;
    project::MeshExportParams params;
    std::filesystem::path output;
    OverwriteFlag overwrite;

    void run(Session& session) const {
        session.start();
        usageFrom("--output", [this] { outputFiles(); });
        project::Project project = source.load();
        std::vector<std::filesystem::path> inputs{source.path()};
        for (const project::MeshFile& mesh : project.meshes) inputs.push_back(mesh.path);
        for (const project::Sample& sample : project.samples) inputs.push_back(sample.scan);
        refuseOverwriting(inputs, outputFiles());
        checkOutputs(outputFiles(), overwrite.isGiven());
        const Task task = session.task("export");
        if (exporting::isPage(output))
            exportPage(session, project, task);
        else
            exportMesh(session, std::move(project), task);
    }

    /// Throws Error when it has no extension of what is written.
    std::vector<std::filesystem::path> outputFiles() const {
        if (exporting::isPage(output)) return {output};
        try {
            return exporting::filesOf(output);
        } catch (const Error&) {
            throw Error(output.string(), "has no extension of what is exported",
                        "choose .glb, .obj, .ply or .html");
        }
    }

    void exportPage(Session& session, const project::Project& project, const Task& task) const {
        exporting::checkPageProgram();
        Stopwatch stopwatch;
        const scene::Scene scene = readScene(project, task.part(0, 0.05));
        nlohmann::json seconds{{"load", stopwatch.lap()}};
        const project::TextureCache cache(project::TextureCache::standardFolder());
        const std::filesystem::path& named = source.path().empty() ? project.meshes[0].path : source.path();
        const project::ExportedPage page =
            project::exportPage(output, named.stem().string(), project, scene, cameraFor(project, scene),
                                metadata(project), task.part(0.05, 0.98), &cache);
        stopwatch.lap();
        writeFileAtomically(output, page.html);
        seconds["synthesis"] = page.synthesisSeconds;
        seconds["write"] = page.writeSeconds + stopwatch.lap();
        task.report(1);
        const double total = totalOf(seconds);
        seconds["total"] = total;
        session.finish({{"faces", page.faces},
                        {"objects", page.objects},
                        {"bytes", page.html.size()},
                        {"seconds", seconds}},
                       fmt::format("{}: {} faces of {} {}, {:.1f} MB; {:.2f} s", output.string(), page.faces,
                                   page.objects, page.objects == 1 ? "object" : "objects",
                                   double(page.html.size()) * 1e-6, total));
    }

    void exportMesh(Session& session, project::Project project, const Task& task) const {
        const exporting::MeshFormat format = exporting::meshFormat(output);
        Stopwatch stopwatch;
        const LoadedProject loaded = loadProject(std::move(project), task.part(0, 0.3));
        nlohmann::json seconds{{"load", stopwatch.lap()}};
        const project::TextureCache cache(project::TextureCache::standardFolder());
        const project::WornPaints worn =
            project::wornPaints(loaded.project, loaded.scene, loaded.paints, task.part(0.3, 0.6), &cache);
        seconds["synthesis"] = stopwatch.lap();
        const project::ExportedMesh mesh =
            project::paintMesh(loaded.project, loaded.scene, worn, format, params, task.part(0.6, 0.95));
        seconds["atlas"] = mesh.atlasSeconds;
        seconds["bake"] = mesh.bakeSeconds;
        stopwatch.lap();
        exporting::writeTexturedScene(output, mesh.scene, metadata(loaded.project));
        seconds["write"] = stopwatch.lap();
        task.report(1);
        report(session, mesh, seconds);
    }

    ImageMetadata metadata(const project::Project& project) const {
        nlohmann::json json = parametersToJson(params);
        json.update(paintParameters(project));
        json.update(sceneParameters(project));
        return pictureMetadata("export", json);
    }

    static double totalOf(const nlohmann::json& seconds) {
        double total = 0;
        for (const auto& [part, value] : seconds.items()) total += value.get<double>();
        return total;
    }

    void report(Session& session, const project::ExportedMesh& mesh, nlohmann::json seconds) const {
        const double total = totalOf(seconds);
        seconds["total"] = total;
        std::size_t vertices = 0;
        for (const exporting::TexturedObject& object : mesh.scene.objects)
            vertices += object.positions.size();
        const exporting::AtlasReport& report = mesh.report;
        const nlohmann::json json{{"faces", report.faces},
                                  {"objects", mesh.scene.objects.size()},
                                  {"vertices", vertices},
                                  {"charts", report.charts},
                                  {"coverage", report.coverage},
                                  {"overlap", report.overlap},
                                  {"texel_density_p5", report.densityP5},
                                  {"texel_density_p95", report.densityP95},
                                  {"padding", report.padding},
                                  {"seconds", seconds}};
        std::string text =
            fmt::format("{}: {} faces of {} {}", output.string(), report.faces, mesh.scene.objects.size(),
                        mesh.scene.objects.size() == 1 ? "object" : "objects");
        if (mesh.scene.texture.empty())
            text += fmt::format(", a colour for each of {} vertices", vertices);
        else
            text += fmt::format(", {} charts cover {:.0f} % of {} x {} px, {:.4g}..{:.4g} px a unit",
                                report.charts, report.coverage * 100, params.atlas, params.atlas,
                                report.densityP5, report.densityP95);
        if (!mesh.scene.texture.empty() && report.padding < params.padding)
            text += fmt::format(", {} px apart for want of room", report.padding);
        session.finish(json, text + fmt::format("; {:.2f} s", total));
    }
};

}  // namespace

void addExportCommand(CLI::App& root, Session& session) {
    CLI::App* command = root.add_subcommand(
        "export",
        "Write the painted mesh for other programs: GLB, OBJ with a picture, or PLY (§4.3 for the views that "
        "lay it flat); or a page that shows it in any light");
    auto state = std::make_shared<ExportCommand>();
    state->source.addTo(*command);
    command
        ->add_option(
            "-o,--output", state->output,
            "What to write: .glb (one file), .obj (with .mtl and .png beside it), .ply (a colour a vertex, "
            "no "
            "texture), or .html: one page for any browser, without a server, that shows the view-aligned and "
            "the view-dependent method with a light to drag and gradients to choose")
        ->required();
    addParameterFlags(*command, state->params);
    state->overwrite.addTo(*command);
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli
