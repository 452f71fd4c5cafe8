#include "app/cli/project_source.h"
#include "core/project/mesh_export.h"
#include "core/project/render_method.h"

#include <spdlog/fmt/fmt.h>

#include <memory>

namespace chiaro::cli {

namespace {

struct ExportCommand {
    ProjectSource source;
    project::MeshExportParams params;
    std::filesystem::path output;
    bool mayReplace = false;

    void run(Session& session) const {
        session.start();
        usageFrom("--output", [this] { exporting::meshFormat(output); });
        const exporting::MeshFormat format = exporting::meshFormat(output);
        project::Project project = source.load();
        std::vector<std::filesystem::path> inputs{source.path()};
        for (const project::MeshFile& mesh : project.meshes) inputs.push_back(mesh.path);
        for (const project::Sample& sample : project.samples) inputs.push_back(sample.scan);
        refuseOverwriting(inputs, exporting::filesOf(output));
        exporting::checkMeshOutput(output, mayReplace);

        const Task task = session.task("export");
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

    void report(Session& session, const project::ExportedMesh& mesh, nlohmann::json seconds) const {
        double total = 0;
        for (const auto& [part, value] : seconds.items()) total += value.get<double>();
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
        "lay it flat)");
    auto state = std::make_shared<ExportCommand>();
    state->source.addTo(*command);
    command
        ->add_option(
            "-o,--output", state->output,
            "Mesh to write: .glb (one file), .obj (with .mtl and .png beside it), or .ply (a colour a "
            "vertex, no texture)")
        ->required();
    addParameterFlags(*command, state->params);
    command->add_flag("--overwrite", state->mayReplace, "Replace files that are there already");
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli
