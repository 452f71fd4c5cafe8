#include "app/cli/project_source.h"
#include "core/base/color.h"
#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>

#include <memory>

namespace chiaro::cli {

namespace {

struct Seconds {
    double load = 0;
    double guide = 0;
    double synthesis = 0;
    double shade = 0;
    double total() const { return load + guide + synthesis + shade; }
};

/// Depth as files hold it: -1 outside, as in light pictures, since many programs refuse infinities.
ScalarImage finiteDepth(ScalarImage depth) {
    for (float& value : depth.pixels())
        if (std::isinf(value)) value = -1;
    return depth;
}

struct RenderCommand {
    ProjectSource source;
    std::filesystem::path output;
    std::filesystem::path auxiliary;
    std::string size = "1024x1024";
    std::string background = "#ffffff";

    void run(Session& session) const {
        session.start();
        const glm::ivec2 pixels = sizeFrom("--size", size);
        if (background != "transparent") usageFrom("--background", [&] { colorFromHex(background); });
        if (!isWritableImage(output))
            throw Error(output.string(), "has no extension of a picture", "choose .png, .exr or .tif");
        const project::Project project = source.load();
        std::vector<std::filesystem::path> inputs{project.mesh, source.path()};
        for (const project::Sample& sample : project.samples) inputs.push_back(sample.scan);
        refuseOverwriting(inputs, {output});
        const Task task = session.task("render");
        Seconds seconds;
        Stopwatch stopwatch;
        LoadedProject loaded = loadProject(project, task.part(0, 0.7));
        for (const project::Paint& paint : loaded.paints) seconds.synthesis += paint.levelSeconds;
        seconds.load = stopwatch.lap() - seconds.synthesis;
        const scene::RayScene rays(loaded.scene, task.part(0.7, 0.75));
        const scene::Camera camera = project::cameraFor(loaded.project, loaded.scene);
        const scene::GBuffer gbuffer =
            scene::castGBuffer(rays, loaded.scene.lights, camera, pixels.x, pixels.y, task.part(0.75, 0.9));
        seconds.guide = stopwatch.lap();
        const methods::Frame frame =
            project::renderFrame(loaded.project, loaded.scene, loaded.paints, gbuffer, task.part(0.9, 1));
        seconds.shade = stopwatch.lap();
        const ImageMetadata metadata = pictureMetadata("render", parameters(loaded.project, pixels));
        writePicture(frame.picture, metadata);
        if (!auxiliary.empty()) writeAuxiliary(gbuffer, frame, metadata);
        report(session, loaded, gbuffer, seconds);
    }

    nlohmann::json parameters(const project::Project& project, glm::ivec2 pixels) const {
        nlohmann::json json{
            {"method", project.method},
            {"size", {pixels.x, pixels.y}},
            {"mesh", project.mesh.filename().string()},
            {"camera", {project.camera.azimuth, project.camera.elevation, project.camera.distance}},
            {"background", background}};
        for (const project::Sample& sample : project.samples)
            json["samples"].push_back(sample.scan.filename().string());
        for (const scene::Light& light : project.lights)
            json["lights"].push_back({light.vector.x, light.vector.y, light.vector.z, light.intensity});
        json.update(parametersToJson(project.levels));
        json.update(parametersToJson(project.levels.quilt));
        json.update(parametersToJson(project.viewAligned));
        return json;
    }

    /// EXR holds scene-linear colours, the other formats display-referred ones.
    void writePicture(ColorAlphaImage picture, const ImageMetadata& metadata) const {
        if (background != "transparent") {
            ColorImage opaque = methods::over(picture, colorFromHex(background));
            if (output.extension() == ".exr")
                for (glm::vec3& pixel : opaque.pixels()) pixel = linearFromSrgb(pixel);
            return writeImage(output, opaque, metadata);
        }
        if (output.extension() == ".exr")
            for (glm::vec4& pixel : picture.pixels())
                pixel = glm::vec4(linearFromSrgb(glm::vec3(pixel)), pixel.a);
        writeImage(output, picture, metadata);
    }

    void writeAuxiliary(const scene::GBuffer& gbuffer, const methods::Frame& frame,
                        const ImageMetadata& metadata) const {
        writeImage(auxiliary / "light.exr", gbuffer.light, metadata);
        writeImage(auxiliary / "id.png", gbuffer.objectId, metadata);
        writeImage(auxiliary / "depth.exr", finiteDepth(gbuffer.depth), metadata);
        writeImage(auxiliary / "normal.exr", gbuffer.normal, metadata);
        writeImage(auxiliary / "texture.exr", frame.texture, metadata);
    }

    void report(Session& session, const LoadedProject& loaded, const scene::GBuffer& gbuffer,
                const Seconds& seconds) const {
        const std::span<const std::uint16_t> ids = gbuffer.objectId.pixels();
        const auto covered = ids.size() - std::size_t(std::count(ids.begin(), ids.end(), 0));
        std::size_t blocks = 0;
        double error = 0;
        for (const project::Paint& paint : loaded.paints) {
            blocks += paint.levels.report.blocks;
            error += paint.levels.report.overlapError * double(paint.levels.report.blocks);
        }
        const nlohmann::json json{{"method", loaded.project.method},
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
    CLI::App* command = root.add_subcommand("render", "Paint a mesh and write the picture (§4)");
    auto state = std::make_shared<RenderCommand>();
    state->source.addTo(*command);
    command->add_option("-o,--output", state->output, "Picture to write: .png, .exr (scene-linear) or .tif")
        ->required();
    command->add_option("--size", state->size,
                        "WIDTHxHEIGHT, each 1..16384 px, together at most 64 megapixels (default 1024x1024)");
    command->add_option("--background", state->background, "#rrggbb or transparent (default #ffffff)");
    command->add_option("--aux", state->auxiliary,
                        "Folder for light.exr, id.png, depth.exr, normal.exr and texture.exr of this "
                        "picture; light and depth are -1 outside the objects");
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli
