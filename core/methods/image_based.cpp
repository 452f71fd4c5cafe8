#include "core/methods/image_based.h"

#include "core/base/error.h"
#include "core/methods/object_guide.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>

namespace chiaro::methods {

using synthesis::BlockSite;
using synthesis::CandidateArea;

const ParameterTable<ImageBasedParams>& ImageBasedParams::table() {
    static const auto table = ParameterTable<ImageBasedParams>().add(
        &ImageBasedParams::window,
        ParameterSpec::integer("window", "Window", "blocks", 0, 64,
                               "How far from its own light a piece of the sample may be used: more gives "
                               "better seams, less follows the light more closely."));
    return table;
}

namespace {

double meanLight(const ObjectGuide& guide, const BlockSite& site) {
    double sum = 0;
    std::size_t count = 0;
    for (int y = site.position.y; y < site.position.y + site.size.y; ++y)
        for (int x = site.position.x; x < site.position.x + site.size.x; ++x) {
            if (!guide.covered(x, y)) continue;
            sum += double(guide.light(x, y));
            ++count;
        }
    return count > 0 ? sum / double(count) : 0;
}

/// The quilting of one object.
struct ObjectWork {
    const ObjectGuide& guide;
    synthesis::QuiltTask task;
    synthesis::QuiltParams params;

    ObjectWork(const ImageBasedTask& view, const SampleTexture& sample, const ImageBasedParams& wanted,
               std::size_t index)
        : guide(view.guides[index]), params(wanted.quilt) {
        task.source = sample.pixels;
        task.prepared = sample.prepared;
        task.width = guide.covered.width();
        task.height = guide.covered.height();
        task.valid = &guide.covered;
        if (!view.filled.empty() && !view.filled[index].where.empty()) {
            task.filled = &view.filled[index].pixels;
            task.filledWhere = &view.filled[index].where;
        }
        if (!view.previous.empty() && !view.previous[index].where.empty()) {
            task.previous = &view.previous[index].pixels;
            task.previousWhere = &view.previous[index].where;
            task.previousWeight = view.previousWeight;
        }
        params = synthesis::fittedBlock(params, task);
        params.seed += index;  // objects of one paint don't repeat each other
        task.candidates = [this, window = wanted.window](const BlockSite& site) {
            return windowAround(meanLight(guide, site), window, params.block, *task.source);
        };
    }
    ObjectWork(const ObjectWork&) = delete;
    ObjectWork& operator=(const ObjectWork&) = delete;
};

/// The search forms that a synthesis makes for itself.
using OwnSearchTextures = std::map<const ColorImage*, synthesis::SearchTexture>;

SampleTexture prepared(const SampleTexture& sample, OwnSearchTextures& own) {
    if (sample.prepared) return sample;
    return {sample.pixels, &own.try_emplace(sample.pixels, *sample.pixels).first->second};
}

std::vector<std::unique_ptr<ObjectWork>> planned(const ImageBasedTask& view, const SampleTextures& samples,
                                                 const ImageBasedParams& params, OwnSearchTextures& own) {
    std::vector<std::unique_ptr<ObjectWork>> works(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (view.guides[i].empty()) continue;
        if (!samples[i].pixels || samples[i].pixels->empty())
            throw Error("object " + std::to_string(i + 1), "wears a sample without a pixel",
                        "choose a strip of at least one pixel");
        works[i] = std::make_unique<ObjectWork>(view, prepared(samples[i], own), params, i);
    }
    return works;
}

}  // namespace

CandidateArea windowAround(double light, int window, int block, const ColorImage& sample) {
    const int last = sample.width() - block;
    const double middle = light * sample.width() - block / 2.0;  // of the positions, x0 being their centres'
    const double reach = double(window) * block;
    int first = int(std::ceil(middle - reach));
    int end = int(std::floor(middle + reach));
    if (first > end) first = end = int(std::lround(middle));
    first = std::clamp(first, 0, last);
    end = std::clamp(end, 0, last);
    return {first, 0, end - first + 1, sample.height() - block + 1};
}

ImageBasedTexture synthesizeImageBased(const scene::GBuffer& gbuffer, const SampleTextures& samples,
                                       const ImageBasedParams& params, const Task& task) {
    ImageBasedTask view;
    view.guides = objectGuides(gbuffer, samples.size());
    return synthesizeImageBased(view, samples, params, task);
}

ImageBasedTexture synthesizeImageBased(const ImageBasedTask& view, const SampleTextures& samples,
                                       const ImageBasedParams& params, const Task& task) {
    ImageBasedParams::table().check(params);
    synthesis::QuiltParams::table().check(params.quilt);
    task.checkpoint();
    OwnSearchTextures own;
    auto works = planned(view, samples, params, own);
    std::size_t blocks = 0;
    for (const auto& work : works)
        if (work) blocks += synthesis::blockCount(work->task, work->params);
    ImageBasedTexture texture;
    texture.objects.resize(samples.size());
    std::vector<std::vector<synthesis::PlacedBlock>> placed(samples.size());
    Task::Steps steps(task, std::max<std::size_t>(blocks, 1));
    tbb::parallel_for(std::size_t(0), works.size(), [&](std::size_t i) {
        if (!works[i]) return;
        synthesis::QuiltResult made = synthesis::quilt(works[i]->task, works[i]->params, steps);
        texture.objects[i] = {works[i]->guide.origin, std::move(made.texture), works[i]->guide.covered};
        placed[i] = std::move(made.blocks);
        works[i].reset();
    });
    synthesis::QuiltResult all;
    for (const auto& object : placed) all.blocks.insert(all.blocks.end(), object.begin(), object.end());
    texture.report = all.report();
    return texture;
}

Frame shadeImageBased(const scene::GBuffer& gbuffer, const std::vector<const gradient::Gradient*>& gradients,
                      const ImageBasedTexture& texture, const Task& task) {
    return shade(
        gbuffer, gradients,
        [&](std::uint16_t object, int x, int y, float) {
            const ObjectTexture& worn = texture.objects[object - 1u];
            return worn.pixels(x - worn.origin.x, y - worn.origin.y);
        },
        task);
}

}  // namespace chiaro::methods
