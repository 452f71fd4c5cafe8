#include "core/methods/image_based_animation.h"

#include "core/base/random.h"

#include <algorithm>

namespace chiaro::methods {

namespace {

/// Another arrangement of strokes for each keyframe, so that blending two of them mixes unrelated textures;
/// the first is that of a single picture.
std::uint64_t keyframeSeed(std::uint64_t seed, int index) {
    return index == 0 ? seed : Random(seed, std::uint64_t(index)).bits() >> 11;
}

/// Two textures laid over each other, by their weights and how far each is to be trusted.
KnownTexture blendedTextures(Blend blend, const CarriedTexture& first, float firstWeight,
                             const CarriedTexture& second, float secondWeight) {
    const int width = first.pixels.width(), height = first.pixels.height();
    KnownTexture known{ColorImage(width, height, glm::vec3(0)), synthesis::PixelMask(width, height, 0)};
    for (std::size_t i = 0; i < known.pixels.pixelCount(); ++i) {
        const float a = firstWeight * first.confidence.pixels()[i];
        const float b = secondWeight * second.confidence.pixels()[i];
        if (a + b <= 0) continue;
        known.pixels.pixels()[i] = blended(blend, first.pixels.pixels()[i], a, second.pixels.pixels()[i], b);
        known.where.pixels()[i] = 1;
    }
    return known;
}

KnownTexture trusted(CarriedTexture carried) {
    KnownTexture known{std::move(carried.pixels), {}};
    known.where = synthesis::PixelMask(known.pixels.width(), known.pixels.height(), 0);
    std::ranges::transform(carried.confidence.pixels(), known.where.pixels().begin(),
                           [](float confidence) { return std::uint8_t(confidence > 0); });
    return known;
}

}  // namespace

ImageBasedAnimation::ImageBasedAnimation(FrameViews views, SampleTextures samples,
                                         const ImageBasedParams& params, const CoherenceParams& coherence)
    : m_views(std::move(views)), m_samples(std::move(samples)), m_params(params), m_coherence(coherence) {
    CoherenceParams::table().check(coherence);
}

ImageBasedTexture ImageBasedAnimation::texture(int frame, const Task& task) {
    if (m_coherence.mode == Coherence::Independent)
        return synthesizeImageBased(*m_views(frame, task).gbuffer, m_samples, m_params, task);
    return m_coherence.hasKeyframes() ? fromKeyframes(frame, task) : fromPrevious(frame, task);
}

ImageBasedTexture ImageBasedAnimation::fromKeyframes(int frame, const Task& task) {
    const int index = (frame - 1) / m_coherence.every;
    const float t = float((frame - 1) % m_coherence.every) / float(m_coherence.every);
    const SharedTexture before = keyframe(index, task.part(0, 0.4));
    if (t == 0 && m_coherence.movesTextures()) return before->texture;
    const SharedTexture after = t > 0 ? keyframe(index + 1, task.part(0.4, 0.8)) : before;
    const FrameView view = m_views(frame, task);
    ImageBasedTask rest;
    rest.guides = objectGuides(*view.gbuffer, m_samples.size());
    const std::vector<CarriedTexture> first = carried(*before, view, rest.guides);
    const std::vector<CarriedTexture> second = carried(*after, view, rest.guides);
    for (std::size_t i = 0; i < rest.guides.size(); ++i)
        rest.filled.push_back(blendedTextures(m_coherence.blend, first[i], 1 - t, second[i], t));
    return synthesizeImageBased(rest, m_samples, m_params, task.part(0.8, 1));
}

ImageBasedAnimation::SharedTexture ImageBasedAnimation::keyframe(int index, const Task& task) {
    if (const auto found = m_keyframes.find(index); found != m_keyframes.end()) return found->second;
    ImageBasedTask work;
    work.guides = keyframeGuides(index, task.part(0, 0.5));
    ImageBasedParams params = m_params;
    params.quilt.seed = keyframeSeed(m_params.quilt.seed, index);
    auto made = std::make_shared<FrameTexture>();
    made->view = m_views(1 + index * m_coherence.every, task);
    made->texture = synthesizeImageBased(work, m_samples, params, task.part(0.5, 1));
    std::erase_if(m_keyframes, [index](const auto& other) { return std::abs(other.first - index) > 1; });
    return m_keyframes[index] = std::move(made);
}

/// What the keyframe shows, and where a texture that stays in the picture will be needed: wherever the
/// objects come until the keyframes beside it, with the light of the nearest frame.
std::vector<ObjectGuide> ImageBasedAnimation::keyframeGuides(int index, const Task& task) {
    const int middle = 1 + index * m_coherence.every;
    std::vector<ObjectGuide> guides = objectGuides(*m_views(middle, task).gbuffer, m_samples.size());
    if (m_coherence.movesTextures()) return guides;
    for (int step = 1; step < m_coherence.every; ++step)
        for (const int frame : {middle - step, middle + step}) {
            if (frame < 1) continue;
            const std::vector<ObjectGuide> others =
                objectGuides(*m_views(frame, task).gbuffer, m_samples.size());
            for (std::size_t i = 0; i < guides.size(); ++i) extend(guides[i], others[i]);
        }
    return guides;
}

ImageBasedTexture ImageBasedAnimation::fromPrevious(int frame, const Task& task) {
    if (m_lastFrame > frame) m_lastFrame = 0;
    const int first = m_lastFrame;
    while (m_lastFrame < frame) {
        const double begin = double(m_lastFrame - first) / double(frame - first);
        const double end = double(m_lastFrame + 1 - first) / double(frame - first);
        static const FrameTexture nothing;
        m_last = nextFrame(m_lastFrame > 0 ? *m_last : nothing, m_lastFrame + 1, task.part(begin, end));
        ++m_lastFrame;
    }
    return m_last->texture;
}

ImageBasedAnimation::SharedTexture ImageBasedAnimation::nextFrame(const FrameTexture& last, int frame,
                                                                  const Task& task) const {
    auto next = std::make_shared<FrameTexture>();
    next->view = m_views(frame, task);
    ImageBasedTask work;
    work.guides = objectGuides(*next->view.gbuffer, m_samples.size());
    work.previousWeight = m_coherence.temporalWeight;
    if (last.view.gbuffer)
        for (CarriedTexture& one : carried(last, next->view, work.guides))
            work.previous.push_back(trusted(std::move(one)));
    next->texture = synthesizeImageBased(work, m_samples, m_params, task);
    return next;
}

std::vector<CarriedTexture> ImageBasedAnimation::carried(const FrameTexture& from, const FrameView& to,
                                                         const std::vector<ObjectGuide>& guides) const {
    std::vector<CarriedTexture> textures;
    Image<scene::SeenPoint> seen;
    if (m_coherence.movesTextures()) seen = scene::seenFrom(*to.gbuffer, to.camera, from.view.camera);
    for (std::size_t i = 0; i < guides.size(); ++i)
        textures.push_back(m_coherence.movesTextures() ? moved(from, i, guides[i], *to.gbuffer, seen)
                                                       : stayed(from.texture.objects[i], guides[i]));
    return textures;
}

}  // namespace chiaro::methods
