#include "app/cli/measure_command.h"
#include "app/cli/sample_source.h"
#include "app/cli/sheet.h"
#include "core/base/atomic_file.h"
#include "core/metrics/distortion.h"
#include "core/metrics/study.h"

#include <spdlog/fmt/fmt.h>

#include <memory>

namespace chiaro::cli {

namespace {

struct StudyCommand {
    SampleSource source;
    metrics::StudyParams params;
    std::filesystem::path folder;

    void run(Session& session) {
        session.start();
        params.seed = session.flags.seed;
        Stopwatch stopwatch;
        std::vector<metrics::StudyTexture> textures{{source.path().stem().string(), source.readStrip()}};
        std::ranges::move(metrics::builtInTextures(), std::back_inserter(textures));
        const Task task = session.task("study");
        const std::vector<metrics::StudyPoint> points = metrics::runStudy(textures, params, task);
        writeFileAtomically(folder / "study.csv", metrics::studyCsv(points));
        const ImageMetadata metadata = pictureMetadata(
            "measure study", {{"sample", source.path().filename().string()}, {"seed", params.seed}});
        for (const metrics::StudyFigure& figure : metrics::studyFigures(points)) {
            writeFileAtomically(folder / (figure.name + ".svg"), figure.svg());
            writeImage(folder / (figure.name + ".png"), figure.picture(), metadata);
        }
        writeImage(folder / "distortions.png", sheetOf(textures), metadata);
        const double seconds = stopwatch.lap();
        session.finish({{"points", points.size()},
                        {"textures", textures.size()},
                        {"blocks", params.blocks},
                        {"seconds", seconds}},
                       fmt::format("{}: study.csv; rotation, scale and discontinuity as .svg and .png; "
                                   "distortions.png; {} points in {:.1f} s",
                                   folder.string(), points.size(), seconds));
    }

    /// What the metric was shown: a row a texture, as it is and in some of its distortions, the same part of
    /// each.
    ColorImage sheetOf(const std::vector<metrics::StudyTexture>& textures) const {
        std::vector<ColorImage> pictures;
        for (const auto& [name, picture] : textures)
            for (const ColorImage& one :
                 {picture, metrics::rotated(picture, 45), metrics::scaled(picture, 0.5, 0.5),
                  metrics::scaled(picture, 2, 2), metrics::torn(picture, 4, params.seed),
                  metrics::torn(picture, 32, params.seed)})
                pictures.push_back(middleOf(one));
        return contactSheet(pictures, 6, 8);
    }

    static ColorImage middleOf(const ColorImage& picture) {
        constexpr int largest = 160;
        const int width = std::min(largest, picture.width()), height = std::min(largest, picture.height());
        ColorImage middle(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                middle(x, y) =
                    picture(x + (picture.width() - width) / 2, y + (picture.height() - height) / 2);
        return middle;
    }
};

}  // namespace

void addStudyCommand(CLI::App& measure, Session& session) {
    CLI::App* command = measure.add_subcommand(
        "study",
        "How the metric answers to rotation, scale and discontinuity, on three built-in textures and a strip "
        "(§5.1, figures 4 to 6), at blocks of 4, 8 and 12 px");
    auto state = std::make_shared<StudyCommand>();
    state->source.addStripTo(*command, "--sample")->required();
    command
        ->add_option(
            "-o,--output", state->folder,
            "Folder for study.csv, the curves of rotation, scale and discontinuity, each as .svg and "
            ".png, and distortions.png")
        ->required();
    command
        ->add_option_function<std::string>(
            "--pixels", [state](const std::string& text) { state->params.pixels = pixelsFrom(text); },
            "How many pixels of each distorted picture are drawn by chance and measured, or all (default "
            "100)")
        ->type_name("");
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli
