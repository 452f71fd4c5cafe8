#include "app/cli/sample_source.h"
#include "app/cli/sheet.h"
#include "core/gradient/gradient.h"
#include "core/synthesis/levels.h"

#include <spdlog/fmt/fmt.h>

#include <memory>

namespace chiaro::cli {

namespace {

struct LevelsCommand {
    SampleSource source;
    synthesis::LevelParams params;
    std::filesystem::path folder;

    void run(Session& session) {
        session.start();
        const Task task = session.task("levels");
        const ColorImage strip = source.readStrip();
        const gradient::Separation separation =
            gradient::separate(strip, source.sample().gradient, task.part(0, 0.1));
        Stopwatch stopwatch;
        const synthesis::LevelStack stack =
            synthesis::makeLevels(strip, separation.gradient, params, task.part(0.1, 1));
        const double seconds = stopwatch.lap();
        write(stack, separation.gradient);
        session.finish({{"count", params.count},
                        {"size", params.size},
                        {"blocks", stack.report.blocks},
                        {"seconds", seconds},
                        {"overlap_error", stack.report.overlapError}},
                       fmt::format("{}: {} levels of {} x {} px, {} blocks in {:.2f} s, overlap error {:.6f}",
                                   folder.string(), params.count, params.size, params.size,
                                   stack.report.blocks, seconds, stack.report.overlapError));
    }

    void write(const synthesis::LevelStack& stack, const gradient::Gradient& gradient) const {
        nlohmann::json parameters = source.parameters();
        parameters.update(parametersToJson(params));
        parameters.update(parametersToJson(params.quilt));
        const ImageMetadata metadata = pictureMetadata("levels", parameters);
        for (std::size_t i = 0; i < stack.levels.size(); ++i)
            writeImage(folder / fmt::format("level_{}.exr", i), stack.levels[i], metadata);
        writeImage(folder / "sheet.png", levelSheet(stack, gradient), metadata);
    }
};

}  // namespace

void addLevelsCommand(CLI::App& root, Session& session) {
    CLI::App* command = root.add_subcommand("levels", "Synthesise the level stack of the 3D texture (§4.2)");
    auto state = std::make_shared<LevelsCommand>();
    state->source.addTo(*command);
    command
        ->add_option("-o,--output", state->folder,
                     "Folder for level_0.exr ... and sheet.png, each level tiled 2x2")
        ->required();
    addParameterFlags(*command, state->params);
    addParameterFlags(*command, state->params.quilt);
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli
