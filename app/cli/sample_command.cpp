#include "app/cli/sample_source.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/gradient/gradient.h"

#include <spdlog/fmt/fmt.h>

#include <memory>

namespace chiaro::cli {

namespace {

/// Rows `x,r,g,b` with seven digits, under a header; `columns` gives x for each colour, or else it is the
/// row's number.
void writeColors(const std::filesystem::path& path, const gradient::Gradient& colors,
                 const std::vector<int>& columns = {}) {
    std::string text = "x,r,g,b\n";
    for (std::size_t i = 0; i < colors.size(); ++i)
        text += fmt::format("{},{:.7f},{:.7f},{:.7f}\n", columns.empty() ? int(i) : columns[i], colors[i].r,
                            colors[i].g, colors[i].b);
    writeFileAtomically(path, text);
}

void addInfo(CLI::App& parent, Session& session) {
    CLI::App* command =
        parent.add_subcommand("info", "Size, channels, averages, colours kept by the sort, residue");
    auto source = std::make_shared<SampleSource>();
    source->addTo(*command);
    session.addCommonFlags(*command);
    command->callback([source, &session] {
        session.start();
        const int channels = readImage(source->path()).channels;
        const ColorImage strip = source->readStrip();
        const gradient::Separation separation =
            gradient::separate(strip, source->sample().gradient, session.task("separating"));
        const glm::vec3 dark = separation.averages.front();
        const glm::vec3 light = separation.averages.back();
        nlohmann::json json{{"width", strip.width()},
                            {"height", strip.height()},
                            {"channels", channels},
                            {"kept", separation.order.size()},
                            {"residue", separation.residue},
                            {"dark", {dark.r, dark.g, dark.b}},
                            {"light", {light.r, light.g, light.b}}};
        session.finish(
            json,
            fmt::format("{}: {} x {} px, {} channels\n"
                        "averages from ({:.3f}, {:.3f}, {:.3f}) to ({:.3f}, {:.3f}, {:.3f})\n"
                        "the sort keeps {} of {} colours; averages differ from the gradient by {:.4f} RMS",
                        source->path().string(), strip.width(), strip.height(), channels, dark.r, dark.g,
                        dark.b, light.r, light.g, light.b, separation.order.size(), strip.width(),
                        separation.residue));
    });
}

struct GradientCommand {
    SampleSource source;
    std::filesystem::path output;
    std::filesystem::path averages;
    std::filesystem::path order;

    void run(Session& session) const {
        session.start();
        refuseOverwriting({source.path()}, {output, averages, order});
        const gradient::Separation separation =
            gradient::separate(source.readStrip(), source.sample().gradient, session.task("separating"));
        gradient::Gradient kept;
        for (const int column : separation.order) kept.push_back(separation.averages[std::size_t(column)]);
        if (!averages.empty()) writeColors(averages, separation.averages);
        if (!order.empty()) writeColors(order, kept, separation.order);
        writeColors(output, separation.gradient);
        session.finish(
            {{"columns", separation.gradient.size()}, {"kept", kept.size()}, {"residue", separation.residue}},
            fmt::format("{}: {} colours, {} kept by the sort", output.string(), separation.gradient.size(),
                        kept.size()));
    }
};

void addGradient(CLI::App& parent, Session& session) {
    CLI::App* command = parent.add_subcommand("gradient", "The gradient G(u(x)), one row a column");
    auto state = std::make_shared<GradientCommand>();
    state->source.addTo(*command);
    command->add_option("-o,--output", state->output, "CSV to write: x,r,g,b")->required();
    command->add_option("--averages", state->averages, "Also write the column averages to this CSV");
    command->add_option("--order", state->order,
                        "Also write the sorted list before stretching; x is the column kept");
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

void addTexture(CLI::App& parent, Session& session) {
    CLI::App* command =
        parent.add_subcommand("texture", "The difference image: strip minus gradient, in [-1, 1]");
    auto source = std::make_shared<SampleSource>();
    auto output = std::make_shared<std::filesystem::path>();
    source->addTo(*command);
    command->add_option("-o,--output", *output, "EXR to write, 32-bit float")->required();
    session.addCommonFlags(*command);
    command->callback([source, output, &session] {
        session.start();
        refuseOverwriting({source->path()}, {*output});
        if (output->extension() != ".exr")
            throw Error(output->string(), "can't hold values below 0", "give it the extension .exr");
        const gradient::Separation separation =
            gradient::separate(source->readStrip(), source->sample().gradient, session.task("separating"));
        writeImage(*output, separation.texture, pictureMetadata("sample texture", source->parameters()));
        session.finish({{"width", separation.texture.width()}, {"height", separation.texture.height()}},
                       fmt::format("{}: {} x {} px", output->string(), separation.texture.width(),
                                   separation.texture.height()));
    });
}

struct RecolorCommand {
    SampleSource source;
    std::string stops;
    std::string space = "rgb";
    std::filesystem::path output;

    void run(Session& session) const {
        session.start();
        refuseOverwriting({source.path()}, {output});
        const auto mixing =
            space == "oklab" ? gradient::ColorPath::Space::Oklab : gradient::ColorPath::Space::Rgb;
        gradient::ColorPath path;
        usageFrom("--stops", [&] { path = gradient::parseColorPath(stops, mixing); });
        const gradient::Separation separation =
            gradient::separate(source.readStrip(), source.sample().gradient, session.task("separating"));
        const ColorImage result =
            gradient::recolored(separation.texture, path.sampled(separation.texture.width()));
        nlohmann::json parameters = source.parameters();
        parameters.update({{"stops", colorPathText(path)}, {"space", space}});
        writeImage(output, result, pictureMetadata("sample recolor", parameters));
        session.finish({{"width", result.width()}, {"height", result.height()}},
                       fmt::format("{}: {} x {} px", output.string(), result.width(), result.height()));
    }
};

void addRecolor(CLI::App& parent, Session& session) {
    CLI::App* command = parent.add_subcommand("recolor", "The strip with its texture over another gradient");
    auto state = std::make_shared<RecolorCommand>();
    state->source.addTo(*command);
    command->add_option("--stops", state->stops, "Colour stops: '0 #201040, 0.5 #c04020, 1 #fff0b0'")
        ->required();
    command->add_option("--space", state->space, "Interpolate in rgb or oklab (default rgb)")
        ->check(CLI::IsMember({"rgb", "oklab"}));
    command->add_option("-o,--output", state->output, "Picture to write")->required();
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace

void addSampleCommands(CLI::App& root, Session& session) {
    CLI::App* sample = root.add_subcommand("sample", "Take a paint sample apart and recolour it (§3)");
    sample->require_subcommand(1);
    addInfo(*sample, session);
    addGradient(*sample, session);
    addTexture(*sample, session);
    addRecolor(*sample, session);
}

}  // namespace chiaro::cli
