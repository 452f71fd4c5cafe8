#include "core/project/comparison.h"

#include "core/base/error.h"
#include "core/metrics/coherence.h"
#include "core/metrics/similarity.h"
#include "core/project/animation.h"
#include "core/project/render_method.h"

#include <algorithm>
#include <functional>

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

/// What is measured of one seed.
struct Measures {
    Mean similarity, shading, shadingSquared, image, object;
};

/// The objects that wear one sample, and that sample as pictures show it.
struct MeasuredSample {
    std::vector<bool> wears;  ///< [k] for object k
    metrics::NeighbourIndex index;
};

class Measurer {
public:
    Measurer(const scene::Scene& scene, const std::vector<Paint>& paints,
             const metrics::MeasureParams& params)
        : m_params(params) {
        for (int sample = 0; sample < int(paints.size()); ++sample) {
            std::vector<bool> wears(scene.objects.size() + 1, false);
            for (std::size_t i = 0; i < scene.objects.size(); ++i)
                wears[i + 1] = scene.objects[i].visible && scene.objects[i].sample == sample;
            if (std::ranges::find(wears, true) == wears.end()) continue;
            const Paint& paint = paints[std::size_t(sample)];
            m_samples.push_back(
                {std::move(wears),
                 metrics::NeighbourIndex(gradient::recolored(paint.separation.texture, paint.shown),
                                         params.block)});
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

/// All frames of one method from one seed on; `frames` takes the pictures when it isn't null.
Measures measureSeed(const Project& project, const scene::Scene& scene, const scene::Path& path,
                     const ComparisonParams& params, int seed, const TextureCache* cache,
                     std::vector<ColorAlphaImage>* frames, const std::function<void()>& frameDone) {
    std::vector<Paint> paints;
    for (std::size_t i = 0; i < project.samples.size(); ++i) paints.push_back(preparePaint(project, i));
    const WornPaints worn = wornPaints(project, scene, paints, {}, cache);
    const Shot shot{project, scene, worn, path, params.width, params.height};
    ShotViews views(shot);
    const auto painter = framePainter(shot, views);
    const Measurer measurer(scene, paints, params.measure);
    Measures measures;
    ColorImage before;
    for (int frame = 1; frame <= params.frames; ++frame) {
        const Rendering rendering = painter->paint(frame, {});
        const ColorImage picture = colorsOf(rendering.frame.picture);
        const methods::FrameView view = views.at(frame);
        const auto draw = params.measure.seed + std::uint64_t(seed * params.frames + frame);
        measurer.measure(*view.gbuffer, picture, draw, measures);
        if (frame > 1) measurer.measureChange(views.at(frame - 1), before, view, picture, draw, measures);
        if (frames) frames->push_back(rendering.frame.picture);
        before = picture;
        frameDone();
    }
    return measures;
}

Estimate overSeeds(const std::vector<Measures>& seeds, Mean Measures::*measure, const char* missing) {
    std::vector<Estimate> estimates;
    for (const Measures& one : seeds) estimates.push_back((one.*measure).result());
    const Estimate result = overSeeds(estimates);
    if (result.count == 0)
        throw Error("frames", missing, "make them larger, or let less change from one to the next");
    return result;
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
    std::vector<MethodMeasure> table;
    const auto methods = renderMethods();
    Task::Steps steps(task, methods.size() * std::size_t(params.seeds * params.frames));
    for (const RenderMethod& method : methods) {
        MethodMeasure& column = table.emplace_back();
        column.method = method.key;
        std::vector<Measures> seeds;
        for (int seed = 0; seed < params.seeds; ++seed)
            seeds.push_back(measureSeed(seeded(project, method.key, seed), scene, path, params, seed, cache,
                                        seed == 0 ? &column.frames : nullptr, [&] { steps.done(); }));
        constexpr auto nothing = "show nothing on which a block fits", apart = "share nothing to compare";
        column.similarity = overSeeds(seeds, &Measures::similarity, nothing);
        column.shading = overSeeds(seeds, &Measures::shading, nothing);
        column.shadingSquared = overSeeds(seeds, &Measures::shadingSquared, nothing);
        column.temporalImage = overSeeds(seeds, &Measures::image, apart);
        column.temporalObject = overSeeds(seeds, &Measures::object, apart);
    }
    return table;
}

}  // namespace chiaro::project
