#include "app/picture_export.h"

#include "core/base/image_io.h"
#include "core/project/pipeline.h"

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

bool isWorn(const scene::Scene& scene, int sample) {
    return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const scene::Object& object) {
        return object.visible && object.sample == sample;
    });
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

}  // namespace

void exportPicture(PictureSource source, const PictureSettings& settings, const Task& task) {
    makeMissingPaints(source, task.part(0, 0.5));
    const scene::RayScene rays(source.scene, task.part(0.5, 0.6));
    const scene::GBuffer gbuffer = scene::castGBuffer(rays, source.scene.lights, source.camera,
                                                      settings.width, settings.height, task.part(0.6, 0.8));
    methods::ViewAlignedParams params = source.project.viewAligned;
    float pixelsPerPixel = 1;
    if (settings.keepsScale) {
        const int from = std::max(1, std::min(source.viewportWidth, source.viewportHeight));
        pixelsPerPixel = float(std::min(settings.width, settings.height)) / float(from);
        params.density /= double(pixelsPerPixel);
    }
    const auto paints = paintsOfObjects(source, pixelsPerPixel);
    const methods::Frame frame = methods::renderViewAligned(gbuffer, paints, params, task.part(0.8, 0.95));
    const ImageMetadata metadata{{"Software", "Chiaro " CHIARO_VERSION}};
    task.checkpoint();
    if (settings.transparent)
        writeImage(settings.path, frame.picture, metadata, PixelDepth::Bits8);
    else
        writeImage(settings.path, methods::over(frame.picture, settings.background), metadata,
                   PixelDepth::Bits8);
}

}  // namespace chiaro::app
