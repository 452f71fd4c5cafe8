#include "app/cli/path_flags.h"
#include "app/cli/picture_output.h"
#include "app/cli/project_source.h"
#include "app/cli/sheet.h"
#include "core/base/atomic_file.h"
#include "core/project/comparison_report.h"
#include "core/project/render_method.h"
#include "core/scene/mesh_io.h"

#include <spdlog/fmt/fmt.h>

#include <memory>

namespace chiaro::cli {

namespace {

namespace fs = std::filesystem;
using metrics::Estimate;
using project::MethodMeasure;

nlohmann::json jsonOf(const std::vector<MethodMeasure>& table) {
    nlohmann::json json;
    for (const MethodMeasure& method : table) {
        nlohmann::json& one = json[method.method];
        const auto add = [&one](const std::string& key, const Estimate& estimate) {
            one[key] = estimate.mean;
            one[key + "_se"] = estimate.standardError;
        };
        add("similarity", method.similarity);
        add("shading_mae", method.shading);
        add("shading_mse", method.shadingSquared);
        add("temporal_image", method.temporalImage);
        add("temporal_object", method.temporalObject);
    }
    return json;
}

struct CompareCommand {
    ProjectSource source;
    fs::path folder;
    std::string size = "512x512";
    std::string settings = "report";
    PathFlags path{"approach"};
    project::ComparisonParams params{.measure = {.pixels = 1000}};

    void run(Session& session) const {
        session.start();
        path.checkPeriod();
        project::ComparisonParams wanted = params;
        const glm::ivec2 pixels = sizeFrom("--size", size);
        wanted.width = pixels.x;
        wanted.height = pixels.y;
        project::Project project = source.load();
        if (settings == "report") project = project::animatedAsReported(std::move(project));
        refuseInputs(project, wanted);
        const Task task = session.task("compare");
        const scene::Scene scene = readScene(project, task.part(0, 0.05));
        const project::TextureCache cache(project::TextureCache::standardFolder());
        Stopwatch stopwatch;
        const auto table =
            project::compareMethods(project, scene, path.path(), wanted, task.part(0.05, 1), &cache);
        const std::string markdown = project::comparisonMarkdown(table);
        writeFileAtomically(folder / "table.md", markdown + "\n" + measuredWhat(project, wanted));
        writeFileAtomically(folder / "table.csv", project::comparisonCsv(table));
        writeFileAtomically(folder / "frames.csv", project::framesCsv(table));
        writePictures(project, table);
        nlohmann::json json{
            {"methods", jsonOf(table)},  {"frames", wanted.frames},         {"path", path.name()},
            {"settings", settings},      {"pixels", wanted.measure.pixels}, {"seeds", wanted.seeds},
            {"seconds", stopwatch.lap()}};
        session.finish(json, markdown);
    }

    static std::string meshNames(const project::Project& project) {
        std::string names;
        for (const project::MeshFile& mesh : project.meshes)
            names += (names.empty() ? "" : ", ") + mesh.path.filename().string();
        return names;
    }

    fs::path pictureOf(int frame) const { return folder / fmt::format("frame.{:04}.png", frame); }

    void refuseInputs(const project::Project& project, const project::ComparisonParams& wanted) const {
        std::vector<fs::path> inputs{source.path(), path.name()};
        for (const project::MeshFile& mesh : project.meshes) inputs.push_back(mesh.path);
        for (const project::Sample& sample : project.samples) inputs.push_back(sample.scan);
        std::vector<fs::path> outputs{folder / "table.md", folder / "table.csv", folder / "frames.csv"};
        for (int frame = 1; frame <= wanted.frames; ++frame) outputs.push_back(pictureOf(frame));
        refuseOverwriting(inputs, outputs);
    }

    /// Below the table: what it is of, and the pictures.
    std::string measuredWhat(const project::Project& project, const project::ComparisonParams& wanted) const {
        std::string text = fmt::format(
            "{} frames of {} ({}), {} x {} px, {} pixels measured in each, {} seeds; blocks of {} px. "
            "Methods "
            "animate {}. ± is the standard error. The report measured another mesh, sample and animation: "
            "the "
            "order of its figures is to be compared, not their size.\n",
            wanted.frames, meshNames(project), path.name(), wanted.width, wanted.height,
            wanted.measure.pixels, wanted.seeds, wanted.measure.block,
            settings == "report" ? "as the report describes them" : "as the project says");
        std::string names;
        for (const project::RenderMethod& method : project::renderMethods())
            names += (names.empty() ? "" : ", ") + std::string(method.label);
        text += "\nFrom left to right: " + names + ".\n\n";
        for (int frame = 1; frame <= wanted.frames; ++frame)
            text += fmt::format("![frame {0}](frame.{0:04}.png)\n", frame);
        return text;
    }

    /// The methods side by side, a picture a frame.
    void writePictures(const project::Project& project, const std::vector<MethodMeasure>& table) const {
        for (std::size_t frame = 0; frame < table.front().frames.size(); ++frame) {
            std::vector<ColorImage> pictures;
            nlohmann::json parameters = sceneParameters(project);
            for (const MethodMeasure& method : table) {
                pictures.push_back(methods::over(method.frames[frame], glm::vec3(1)));
                parameters["methods"].push_back(method.method);
            }
            parameters.update(path.parameters());
            parameters["settings"] = settings;
            parameters["frame"] = frame + 1;
            writeImage(pictureOf(int(frame) + 1), contactSheet(pictures, int(pictures.size()), 8),
                       pictureMetadata("compare", parameters));
        }
    }
};

}  // namespace

void addCompareCommand(CLI::App& root, Session& session) {
    CLI::App* command = root.add_subcommand(
        "compare", "Paint an animation by every method and measure it: the report's table (§5)");
    auto state = std::make_shared<CompareCommand>();
    state->source.addTo(*command);
    command
        ->add_option("-o,--output", state->folder,
                     "Folder for table.md, table.csv, frames.csv (every frame alone) and frame.####.png, the "
                     "methods side by side")
        ->required();
    command->add_option("--size", state->size, "WIDTHxHEIGHT of the frames (default 512x512)");
    command->add_option("--frames", state->params.frames, "Frames that are measured (2..1000; default 8)")
        ->check(CLI::Range(2, 1000));
    state->path.addTo(*command);
    command
        ->add_option("--settings", state->settings,
                     "How methods animate: report (image-based frames stay close to the frame before, the 3D "
                     "texture keeps its scale, whatever --follow-zoom says) or project (as the project and "
                     "the flags say; default report)")
        ->check(CLI::IsMember({"report", "project"}));
    command->add_option("--seeds", state->params.seeds, "Syntheses to average over (1..100; default 5)")
        ->check(CLI::Range(1, 100));
    command
        ->add_option("--pixels", state->params.measure.pixels,
                     "Pixels measured in each frame (1..; default 1000, since methods differ by a few "
                     "hundredths of the error's own size)")
        ->check(CLI::Range(1, 1 << 24));
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli
