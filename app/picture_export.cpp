#include "app/picture_export.h"

#include "app/worn_scene.h"
#include "core/base/image_io.h"
#include "core/export/painted_files.h"
#include "core/project/pipeline.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace chiaro::app {

namespace {

/// Objects without a sample are shown as the viewport shows them: grey, without texture.
const PicturePaint& unpainted() {
    static const PicturePaint paint{
        std::make_shared<const synthesis::LevelStack>(synthesis::LevelStack{{ColorImage(64, 64)}, {}}),
        {glm::vec3(0.1F), glm::vec3(0.9F)}};
    return paint;
}

void makeMissingPaints(PictureSource& source, const Task& task) {
    const int count = int(source.paints.size());
    for (int sample = 0; sample < count; ++sample) {
        PicturePaint& paint = source.paints[std::size_t(sample)];
        if (!isWorn(source.scene, sample) || (paint.levels && !paint.gradient.empty())) continue;
        project::Paint made =
            project::preparePaint(source.project.samples[std::size_t(sample)], source.project.levels,
                                  task.part(double(sample) / count, double(sample + 1) / count));
        paint = {std::make_shared<const synthesis::LevelStack>(std::move(made.levels)),
                 std::move(made.shown)};
    }
}

std::vector<methods::ViewAlignedPaint> paintsOfObjects(const PictureSource& source, float pixelsPerPixel) {
    std::vector<methods::ViewAlignedPaint> paints;
    for (std::size_t i = 0; i < source.scene.objects.size(); ++i) {
        const scene::Object& object = source.scene.objects[i];
        const auto sample = std::size_t(object.sample);
        const bool painted = sample < source.paints.size() && source.paints[sample].levels;
        const PicturePaint& paint = painted ? source.paints[sample] : unpainted();
        methods::TexturePlacement placement =
            i < source.placements.size() ? source.placements[i] : methods::TexturePlacement{};
        placement.offset *= pixelsPerPixel;
        paints.push_back({paint.levels.get(), &paint.gradient, placement});
    }
    return paints;
}

/// The view-aligned texture where it lies in the viewport.
methods::Frame placedFrame(PictureSource source, const scene::GBuffer& gbuffer, float pixelsPerPixel,
                           const Task& task) {
    makeMissingPaints(source, task.part(0, 0.7));
    methods::ViewAlignedParams params = source.project.viewAligned;
    params.density /= double(pixelsPerPixel);
    return methods::renderViewAligned(gbuffer, paintsOfObjects(source, pixelsPerPixel), params,
                                      task.part(0.7, 1));
}

/// The textures of the objects' own views; those that are not there yet are made.
methods::Frame viewDependentFrame(const PictureSource& source, const scene::GBuffer& gbuffer,
                                  const Task& task) {
    const WornScene worn(source, task.part(0, 0.9));
    return project::renderFrame(source.project, worn.worn(), gbuffer, task.part(0.9, 1)).frame;
}

ColorImage scaled(const ColorImage& texture, float factor) {
    if (factor == 1) return texture;
    const auto size = [factor](int side) { return std::max(4, int(std::lround(float(side) * factor))); };
    ColorImage result(size(texture.width()), size(texture.height()));
    ColorImage copy = texture;  // OpenCV has no pictures that can't be written to
    const cv::Mat from(copy.height(), copy.width(), CV_32FC3, copy.pixels().data());
    cv::Mat to(result.height(), result.width(), CV_32FC3, result.pixels().data());
    cv::resize(from, to, to.size(), 0, 0, factor < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    return result;
}

/// A texture that is made for this picture: of larger strokes where the picture is larger.
methods::Frame synthesizedFrame(const PictureSource& source, const scene::GBuffer& gbuffer,
                                float pixelsPerPixel, const Task& task) {
    std::vector<project::Paint> paints(source.paints.size());
    for (std::size_t i = 0; i < paints.size(); ++i) {
        if (!isWorn(source.scene, int(i))) continue;
        paints[i] = project::preparePaint(source.project, i, task.part(0, 0.4));
        paints[i].separation.texture = scaled(paints[i].separation.texture, pixelsPerPixel);
        if (!source.paints[i].gradient.empty()) paints[i].shown = source.paints[i].gradient;
    }
    project::Paint bare;
    bare.separation.texture = unpainted().levels->levels.front();
    bare.shown = unpainted().gradient;
    project::WornPaints worn;
    for (const scene::Object& object : source.scene.objects)
        worn.push_back(
            {std::size_t(object.sample) < paints.size() ? &paints[std::size_t(object.sample)] : &bare});
    project::Project project = source.project;
    synthesis::QuiltParams& quilt = project.imageBased.quilt;
    const auto length = [&](int pixels) { return int(std::lround(float(pixels) * pixelsPerPixel)); };
    quilt.block = std::clamp(length(quilt.block), 4, 256);
    quilt.overlap = std::clamp(length(quilt.overlap), 0, 128);
    return project::renderFrame(project, worn, gbuffer, task.part(0.4, 1)).frame;
}

/// By the project's method.
methods::Frame paintedFrame(PictureSource source, const scene::GBuffer& gbuffer, float pixelsPerPixel,
                            const Task& task) {
    if (source.project.method == "view-aligned")
        return placedFrame(std::move(source), gbuffer, pixelsPerPixel, task);
    if (source.project.method == "view-dependent") return viewDependentFrame(source, gbuffer, task);
    return synthesizedFrame(source, gbuffer, pixelsPerPixel, task);
}

}  // namespace

void exportPicture(PictureSource source, const PictureSettings& settings, const Task& task) {
    float pixelsPerPixel = 1;
    if (settings.keepsScale) {
        const int from = std::max(1, std::min(source.viewportWidth, source.viewportHeight));
        pixelsPerPixel = float(std::min(settings.width, settings.height)) / float(from);
    }
    const scene::RayScene rays(source.scene, task.part(0, 0.1));
    const scene::GBuffer gbuffer = scene::castGBuffer(rays, source.scene.lights, source.camera,
                                                      settings.width, settings.height, task.part(0.1, 0.3));
    const methods::Frame frame =
        paintedFrame(std::move(source), gbuffer, pixelsPerPixel, task.part(0.3, 0.95));
    const ImageMetadata metadata{{"Software", "Chiaro " CHIARO_VERSION}};
    task.checkpoint();
    exporting::writePainted(settings.path, frame.picture,
                            settings.transparent ? std::nullopt : std::optional(settings.background),
                            metadata);
}

}  // namespace chiaro::app
