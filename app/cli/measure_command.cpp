#include "app/cli/measure_command.h"

#include "app/cli/data_pictures.h"
#include "app/cli/sample_source.h"
#include "core/metrics/coherence.h"
#include "core/metrics/heat_map.h"
#include "core/metrics/similarity.h"

#include <spdlog/fmt/fmt.h>

#include <charconv>
#include <memory>

namespace chiaro::cli {

namespace {

namespace fs = std::filesystem;
using metrics::Estimate;

/// A flag for each parameter, and --pixels, which takes "all" too.
void addMeasureFlags(CLI::App& command, metrics::MeasureParams& params) {
    const auto& table = metrics::MeasureParams::table();
    const auto specs = std::span(table.specs());
    addParameterFlags(command, specs.first(specs.size() - 1), table.values(params),
                      [&params, &table](std::size_t index, double value) {
                          std::vector<double> values = table.values(params);
                          values[index] = value;
                          table.assign(params, values);
                      });
    command
        .add_option_function<std::string>(
            "--pixels", [&params](const std::string& text) { params.pixels = pixelsFrom(text); },
            "How many pixels are drawn by chance and measured, or all (default 100)")
        ->type_name("");
}

/// The mask: what a picture says, or else where there is light; nothing without either.
std::optional<IdImage> maskFrom(const fs::path& path, const std::optional<ScalarImage>& light) {
    if (!path.empty()) return readIds(path);
    if (!light) return std::nullopt;
    IdImage mask(light->width(), light->height());
    for (std::size_t i = 0; i < mask.pixelCount(); ++i) mask.pixels()[i] = light->pixels()[i] >= 0;
    return mask;
}

struct Results {
    metrics::FrameMeasure frame;
    std::optional<Estimate> image, object;
};

struct MeasureCommand {
    SampleSource source;
    metrics::MeasureParams params;
    fs::path picture, light, mask, next, nextMask, motion;
    fs::path heatMap, shadingMap, matches;
    int object = 0;

    void run(Session& session) const {
        check();
        session.start();
        Stopwatch stopwatch;
        const Results results = measure(session.task("measuring"));
        session.finish(json(results, stopwatch.lap()), text(results));
    }

    void check() const {
        if (picture.empty()) throw CLI::RequiredError("PICTURE");
        if (!source.given()) throw CLI::RequiredError("--sample");
        for (const fs::path& map : {heatMap, shadingMap, matches})
            if (!map.empty() && !isWritableImage(map))
                throw CLI::ValidationError(map.string() +
                                           ": is no picture file; name a .png, .tif, .jpg or .exr");
        refuseOverwriting({source.path(), picture, light, mask, next, nextMask, motion},
                          {heatMap, shadingMap, matches});
    }

    /// A frame's picture and what is known of it.
    struct Input {
        ColorImage picture;
        std::optional<IdImage> objects;
        std::optional<ScalarImage> light;

        metrics::MeasuredFrame frame(int object) const {
            metrics::MeasuredFrame frame;
            frame.picture = &picture;
            frame.objects = objects ? &*objects : nullptr;
            frame.light = light ? &*light : nullptr;
            frame.object = object;
            return frame;
        }
    };

    Results measure(const Task& task) const {
        const ColorImage strip = source.readStrip();
        Input input{sample::readScan(picture), {}, {}};
        if (!light.empty()) input.light = readLight(light);
        input.objects = maskFrom(mask, input.light);
        std::optional<Input> after;
        if (!next.empty())
            after = Input{sample::readScan(next), nextMask.empty() ? input.objects : readIds(nextMask), {}};
        const auto displacement =
            motion.empty() ? std::nullopt : std::optional<Image<glm::vec2>>(readVectors(motion));
        const auto index = naming(
            source.path(), [&] { return metrics::NeighbourIndex(strip, params.block, task.part(0, 0.1)); });
        return naming(picture, [&] {
            const metrics::MeasuredFrame frame = input.frame(object);
            Results results;
            results.frame = measureOne(index, frame, strip, task.part(0.1, 1));
            if (!after) return results;
            results.image = metrics::imageCoherence(index.bins(), frame, after->frame(object), params);
            if (!displacement) return results;
            metrics::SurfaceMotion surface;
            surface.displacement = &*displacement;
            results.object =
                metrics::objectCoherence(index.bins(), frame, after->frame(object), surface, params);
            return results;
        });
    }

    metrics::FrameMeasure measureOne(const metrics::NeighbourIndex& index,
                                     const metrics::MeasuredFrame& frame, const ColorImage& strip,
                                     const Task& task) const {
        if (heatMap.empty() && shadingMap.empty() && matches.empty())
            return metrics::measureFrame(index, frame, params, task);
        const metrics::FrameMaps maps =
            metrics::mapFrame(index, frame, params.neighbours, task.part(0, 0.99));
        writeMaps(maps, strip);
        return params.pixels == 0 ? maps.measure
                                  : metrics::measureFrame(index, frame, params, task.part(0.99, 1));
    }

    void writeMaps(const metrics::FrameMaps& maps, const ColorImage& strip) const {
        nlohmann::json parameters = parametersToJson(params);
        parameters["sample"] = source.path().filename().string();
        parameters["picture"] = picture.filename().string();
        const ImageMetadata metadata = pictureMetadata("measure", parameters);
        writeMap(heatMap, maps.similarity, metadata);
        writeMap(shadingMap, maps.shadingError, metadata);
        if (!matches.empty())
            writeImage(matches, metrics::matchMap(maps.best, strip.width(), strip.height()), metadata);
    }

    /// Values as they are in EXR, as colours with a bar in other files.
    static void writeMap(const fs::path& path, const ScalarImage& values, const ImageMetadata& metadata) {
        if (path.empty()) return;
        if (path.extension() == ".exr") return writeImage(path, values, metadata);
        writeImage(path, metrics::heatMapWithBar(values, 0, metrics::heatMapEnd(values)), metadata);
    }

    nlohmann::json json(const Results& results, double seconds) const {
        nlohmann::json json{{"pixels", results.frame.similarity.count},
                            {"block", params.block},
                            {"neighbours", params.neighbours},
                            {"seconds", seconds}};
        const auto add = [&json](const std::string& key, const std::optional<Estimate>& value) {
            json[key] = value ? nlohmann::json(value->mean) : nlohmann::json();
            json[key + "_se"] = value ? nlohmann::json(value->standardError) : nlohmann::json();
        };
        add("similarity", results.frame.similarity);
        add("shading_mae", results.frame.shadingAbsolute);
        add("shading_mse", results.frame.shadingSquared);
        add("temporal_image", results.image);
        add("temporal_object", results.object);
        return json;
    }

    std::string text(const Results& results) const {
        std::string text = fmt::format("{}: {} pixels, blocks of {} px", picture.string(),
                                       results.frame.similarity.count, params.block);
        const auto add = [&text](const char* label, const std::optional<Estimate>& value) {
            if (value)
                text += fmt::format("\n{:<28}{:.5f} ± {:.5f}", label, value->mean, value->standardError);
        };
        add("similarity error", results.frame.similarity);
        add("shading error, absolute", results.frame.shadingAbsolute);
        add("shading error, squared", results.frame.shadingSquared);
        add("coherence error, image", results.image);
        add("coherence error, object", results.object);
        return text;
    }
};

void addFlags(CLI::App& command, MeasureCommand& state) {
    command.add_option("PICTURE", state.picture, "Picture to measure");
    state.source.addStripTo(command, "--sample");
    command.add_option("--light", state.light,
                       "Its true light, 0 dark to 1 light, negative or NaN outside: for the shading error");
    command.add_option("--mask", state.mask,
                       "Its objects, 8 or 16-bit grey: 0 outside, 1.. the object; blocks lie on one object "
                       "(default: where there is light, or everywhere)");
    command.add_option("--object", state.object, "Measure this object of the mask alone (default: all)")
        ->check(CLI::Range(1, greatestId));
    CLI::Option* next =
        command.add_option("--next", state.next, "The next frame's picture: for coherence in image space");
    command.add_option("--next-mask", state.nextMask, "The next frame's objects (default: those of --mask)")
        ->needs(next);
    command
        .add_option(
            "--motion", state.motion,
            "EXR of displacements to the next frame, channels X and Y, px, x right, y down; NaN where "
            "the point isn't seen there: for coherence in object space")
        ->needs(next);
    addMeasureFlags(command, state.params);
    command.add_option(
        "--heatmap", state.heatMap,
        "Also write the similarity error of every pixel: colours with a bar, or .exr values, -1 "
        "where there is none");
    command.add_option("--shading-map", state.shadingMap, "Also write the shading error of every pixel")
        ->needs("--light");
    command.add_option("--matches", state.matches,
                       "Also write where in the strip each pixel's best match lies: blue left to red right, "
                       "bright top to dark bottom");
}

}  // namespace

int pixelsFrom(const std::string& text) {
    if (text == "all") return 0;
    int pixels = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), pixels);
    if (problem != std::errc() || end != text.data() + text.size() || pixels < 1)
        throw CLI::ValidationError(
            fmt::format("--pixels: is \"{}\"; write a number from 1 on, or all", text));
    return pixels;
}

void addMeasureCommand(CLI::App& root, Session& session) {
    CLI::App* command = root.add_subcommand(
        "measure",
        "How much a picture looks like a strip, how right its shades are, how calm its frames (§5)");
    auto state = std::make_shared<MeasureCommand>();
    addFlags(*command, *state);
    session.addCommonFlags(*command);
    addStudyCommand(*command, session);
    command->callback([state, command, &session] {
        if (command->get_subcommands().empty()) state->run(session);
    });
}

}  // namespace chiaro::cli
