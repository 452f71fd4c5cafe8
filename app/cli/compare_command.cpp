#include "app/cli/picture_output.h"
#include "app/cli/project_source.h"
#include "app/cli/sheet.h"
#include "core/base/atomic_file.h"
#include "core/project/comparison_report.h"
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
    int period = 48;
    project::ComparisonParams params;

    void run(Session& session) const {
        session.start();
        project::ComparisonParams wanted = params;
        const glm::ivec2 pixels = sizeFrom("--size", size);
        wanted.width = pixels.x;
        wanted.height = pixels.y;
        const project::Project project = source.load();
        const scene::Scene scene = readScene(project);
        const project::TextureCache cache(project::TextureCache::standardFolder());
        Stopwatch stopwatch;
        const auto table = project::compareMethods(project, scene, scene::Path::turntable(period), wanted,
                                                   session.task("compare"), &cache);
        const std::string markdown = project::comparisonMarkdown(table);
        writeFileAtomically(folder / "table.md", markdown);
        writeFileAtomically(folder / "table.csv", project::comparisonCsv(table));
        writePictures(project, table);
        nlohmann::json json{{"methods", jsonOf(table)},
                            {"frames", wanted.frames},
                            {"seeds", wanted.seeds},
                            {"seconds", stopwatch.lap()}};
        session.finish(json, markdown);
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
            parameters["frame"] = frame + 1;
            writeImage(folder / fmt::format("frame.{:04}.png", frame + 1),
                       contactSheet(pictures, int(pictures.size()), 8),
                       pictureMetadata("compare", parameters));
        }
    }
};

}  // namespace

void addCompareCommand(CLI::App& root, Session& session) {
    CLI::App* command = root.add_subcommand(
        "compare", "Paint a turntable by every method and measure it: the report's table (§5)");
    auto state = std::make_shared<CompareCommand>();
    state->source.addTo(*command);
    command
        ->add_option("-o,--output", state->folder,
                     "Folder for table.md, table.csv and frame.####.png, the methods side by side")
        ->required();
    command->add_option("--size", state->size, "WIDTHxHEIGHT of the frames (default 512x512)");
    command->add_option("--frames", state->params.frames, "Frames that are measured (2..1000; default 8)")
        ->check(CLI::Range(2, 1000));
    command->add_option("--period", state->period, "Frames in which the turntable goes around (default 48)")
        ->check(CLI::Range(1, 100000));
    command->add_option("--seeds", state->params.seeds, "Syntheses to average over (1..100; default 5)")
        ->check(CLI::Range(1, 100));
    command
        ->add_option("--pixels", state->params.measure.pixels,
                     "Pixels measured in each frame (1..; default 100)")
        ->check(CLI::Range(1, 1 << 24));
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli
