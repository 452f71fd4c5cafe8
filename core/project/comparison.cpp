#include "core/project/comparison.h"

#include "core/base/error.h"
#include "core/metrics/coherence.h"
#include "core/metrics/similarity.h"
#include "core/project/animation.h"
#include "core/project/render_method.h"

#include <algorithm>
#include <array>

namespace chiaro::project {

namespace {

using metrics::Estimate;

/// The picture's colour where objects are; behind them is nothing to measure.
ColorImage colorsOf(const ColorAlphaImage& picture) {
    return methods::over(picture, glm::vec3(1));
}

/// A mean over several estimates, each weighing as many pixels as it has.
class Mean {
public:
    void add(const Estimate& estimate) {
        const double count = double(estimate.count);
        m_sum += count * estimate.mean;
        m_variance += count * count * estimate.standardError * estimate.standardError;
        m_count += estimate.count;
    }
    Estimate result() const {
        if (m_count == 0) return {};
        return {m_sum / double(m_count), std::sqrt(m_variance) / double(m_count), m_count};
    }

private:
    double m_sum = 0, m_variance = 0;
    std::size_t m_count = 0;
};

/// The mean over seeds; its error is the larger one of what pixels and what seeds tell.
Estimate overSeeds(const std::vector<Estimate>& seeds) {
    Mean pixels;
    std::vector<double> means;
    for (const Estimate& one : seeds) {
        pixels.add(one);
        means.push_back(one.mean);
    }
    Estimate result = pixels.result();
    result.standardError = std::max(result.standardError, metrics::estimate(means).standardError);
    return result;
}

constexpr std::array measuredErrors{&MeasuredErrors::similarity, &MeasuredErrors::shading,
                                    &MeasuredErrors::shadingSquared, &MeasuredErrors::temporalImage,
                                    &MeasuredErrors::temporalObject};

MeasuredErrors overSeeds(const std::vector<MeasuredErrors>& seeds) {
    MeasuredErrors errors;
    for (const auto error : measuredErrors) {
        std::vector<Estimate> estimates;
        for (const MeasuredErrors& seed : seeds)
            if ((seed.*error).count > 0) estimates.push_back(seed.*error);
        errors.*error = overSeeds(estimates);
    }
    return errors;
}

/// What is measured of one frame.
struct Measures {
    Mean similarity, shading, shadingSquared, image, object;
    MeasuredErrors result() const {
        return {similarity.result(), shading.result(), shadingSquared.result(), image.result(),
                object.result()};
    }
};

MeasuredErrors overFrames(const std::vector<MeasuredErrors>& frames) {
    MeasuredErrors errors;
    for (const auto error : measuredErrors) {
        Mean mean;
        for (const MeasuredErrors& frame : frames) mean.add(frame.*error);
        errors.*error = mean.result();
    }
    return errors;
}

/// The objects that wear one sample, and that sample as pictures show it.
struct MeasuredSample {
    std::vector<bool> wears;  ///< [k] for object k
    metrics::NeighbourIndex index;
};

class Measurer {
public:
    Measurer(const Project& project, const scene::Scene& scene, const std::vector<Paint>& paints,
             const metrics::MeasureParams& params, const Task& task)
        : m_params(params) {
        for (int sample = 0; sample < int(paints.size()); ++sample) {
            std::vector<bool> wears(scene.objects.size() + 1, false);
            for (std::size_t i = 0; i < scene.objects.size(); ++i)
                wears[i + 1] = scene.objects[i].visible && scene.objects[i].sample == sample;
            if (std::ranges::find(wears, true) == wears.end()) continue;
            try {
                const Paint& paint = paints[std::size_t(sample)];
                m_samples.push_back(
                    {std::move(wears),
                     metrics::NeighbourIndex(gradient::recolored(paint.separation.texture, paint.shown),
                                             params.block, task)});
            } catch (const Error& error) {
                throw Error(project.samples[std::size_t(sample)].scan.string(), error);
            }
        }
    }

    void measure(const scene::GBuffer& gbuffer, const ColorImage& picture, std::uint64_t seed,
                 Measures& measures) const {
        for (const MeasuredSample& sample : m_samples) {
            const IdImage objects = only(gbuffer.objectId, sample);
            const metrics::MeasuredFrame frame{&picture, &objects, &gbuffer.light, 0};
            if (!metrics::anyPixel(metrics::measurable(frame, m_params.block))) continue;
            const metrics::FrameMeasure made = metrics::measureFrame(sample.index, frame, params(seed));
            measures.similarity.add(made.similarity);
            measures.shading.add(*made.shadingAbsolute);
            measures.shadingSquared.add(*made.shadingSquared);
        }
    }

    void measureChange(const methods::FrameView& first, const ColorImage& firstPicture,
                       const methods::FrameView& second, const ColorImage& secondPicture, std::uint64_t seed,
                       Measures& measures) const {
        const auto landings = scene::seenFrom(*first.gbuffer, first.camera, second.camera);
        const auto displacement = scene::screenMotion(*first.gbuffer, first.camera, second.camera);
        const auto seen = metrics::seenInBoth(*first.gbuffer, landings, *second.gbuffer);
        for (const MeasuredSample& sample : m_samples) {
            const IdImage before = only(first.gbuffer->objectId, sample),
                          after = only(second.gbuffer->objectId, sample);
            const metrics::MeasuredFrame a{&firstPicture, &before, nullptr, 0},
                b{&secondPicture, &after, nullptr, 0};
            const metrics::SurfaceMotion motion{&displacement, &seen};
            const metrics::Bins& bins = sample.index.bins();
            // Objects may be too small, or hidden, in one of the frames.
            if (metrics::anyPixel(metrics::comparableInImage(a, b, m_params.block)))
                measures.image.add(metrics::imageCoherence(bins, a, b, params(seed)));
            if (metrics::anyPixel(metrics::comparableOnObject(a, b, motion, m_params.block)))
                measures.object.add(metrics::objectCoherence(bins, a, b, motion, params(seed)));
        }
    }

private:
    metrics::MeasureParams params(std::uint64_t seed) const {
        metrics::MeasureParams seeded = m_params;
        seeded.seed = seed;
        return seeded;
    }
    static IdImage only(const IdImage& ids, const MeasuredSample& sample) {
        IdImage objects = ids;
        for (std::uint16_t& id : objects.pixels())
            if (!sample.wears[id]) id = 0;
        return objects;
    }

    metrics::MeasureParams m_params;
    std::vector<MeasuredSample> m_samples;
};

/// Everything that is made by chance from this seed on.
Project seeded(const Project& project, const std::string& method, int offset) {
    Project other = project;
    other.method = method;
    other.levels.quilt.seed += std::uint64_t(offset);
    other.imageBased.quilt.seed += std::uint64_t(offset);
    return other;
}

/// What every method and seed has in common.
struct Shared {
    const scene::Scene& scene;
    const scene::Path& path;
    const ComparisonParams& params;
    const TextureCache* cache;
};

/// Paints and measures every frame as the seed of that number has it; the first one's pictures are kept.
std::vector<MeasuredErrors> measureSeed(const Project& project, int seed, const Shared& shared,
                                        std::vector<ColorAlphaImage>& pictures, const Task& task) {
    const ComparisonParams& params = shared.params;
    std::vector<Paint> paints;
    for (std::size_t i = 0; i < project.samples.size(); ++i)
        paints.push_back(preparePaint(project, i, task.part(0, 0.2)));
    const WornPaints worn = wornPaints(project, shared.scene, paints, task.part(0.2, 0.4), shared.cache);
    const Shot shot{project, shared.scene, worn, shared.path, params.width, params.height};
    ShotViews views(shot, task.part(0.4, 0.4));
    const auto painter = framePainter(shot, views);
    const Measurer measurer(project, shared.scene, paints, params.measure, task.part(0.4, 0.5));
    std::vector<MeasuredErrors> errors;
    ColorImage before;
    for (int frame = 1; frame <= params.frames; ++frame) {
        const double share = 0.5 / params.frames;
        const Rendering rendering =
            painter->paint(frame, task.part(0.5 + share * (frame - 1), 0.5 + share * frame));
        const ColorImage picture = colorsOf(rendering.frame.picture);
        const methods::FrameView view = views.at(frame);
        const std::uint64_t draw = params.measure.seed + std::uint64_t(seed * params.frames + frame);
        Measures measures;
        measurer.measure(*view.gbuffer, picture, draw, measures);
        if (frame > 1) measurer.measureChange(views.at(frame - 1), before, view, picture, draw, measures);
        errors.push_back(measures.result());
        if (seed == 0) pictures.push_back(rendering.frame.picture);
        before = picture;
        task.checkpoint();
    }
    return errors;
}

/// Throws Error when frames have too little in them to say anything.
void checkMeasured(const MeasuredErrors& errors) {
    if (errors.similarity.count == 0)
        throw Error("frames", "show nothing on which a block fits",
                    "make them larger, or let the camera come nearer");
    if (errors.temporalImage.count == 0 || errors.temporalObject.count == 0)
        throw Error("frames", "share nothing that could be compared", "let less change from one to the next");
}

MethodMeasure measureMethod(const Project& project, const std::string& method, const Shared& shared,
                            const Task& task) {
    MethodMeasure column;
    column.method = method;
    const int count = shared.params.seeds;
    std::vector<std::vector<MeasuredErrors>> frames(std::size_t(shared.params.frames));
    std::vector<MeasuredErrors> seeds;
    for (int seed = 0; seed < count; ++seed) {
        const Task part = task.part(double(seed) / count, double(seed + 1) / count);
        const auto errors = measureSeed(seeded(project, method, seed), seed, shared, column.frames, part);
        for (std::size_t i = 0; i < errors.size(); ++i) frames[i].push_back(errors[i]);
        seeds.push_back(overFrames(errors));
    }
    static_cast<MeasuredErrors&>(column) = overSeeds(seeds);
    checkMeasured(column);
    for (const auto& frame : frames) column.perFrame.push_back(overSeeds(frame));
    return column;
}

}  // namespace

Project animatedAsReported(Project project) {
    project.viewAligned.followZoom = false;
    project.coherence = {};
    project.coherence.mode = methods::Coherence::Previous;
    return project;
}

std::vector<MethodMeasure> compareMethods(const Project& project, const scene::Scene& scene,
                                          const scene::Path& path, const ComparisonParams& params,
                                          const Task& task, const TextureCache* cache) {
    const Shared shared{scene, path, params, cache};
    std::vector<MethodMeasure> table;
    const auto methods = renderMethods();
    const double share = 1 / double(methods.size());
    for (std::size_t i = 0; i < methods.size(); ++i)
        table.push_back(measureMethod(project, methods[i].key, shared,
                                      task.part(share * double(i), share * double(i + 1))));
    return table;
}

}  // namespace chiaro::project
