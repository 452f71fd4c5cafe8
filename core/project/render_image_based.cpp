#include "core/project/render_image_based.h"

#include "core/methods/image_based_animation.h"

#include <nlohmann/json.hpp>

#include <chrono>

namespace chiaro::project {

namespace {

double secondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::vector<const gradient::Gradient*> gradientsOf(const WornPaints& worn) {
    std::vector<const gradient::Gradient*> gradients;
    for (const Worn& one : worn) gradients.push_back(&one.paint->shown);
    return gradients;
}

/// The samples' textures, prepared for many searches.
class PreparedTextures {
public:
    explicit PreparedTextures(const WornPaints& worn) {
        for (const Worn& one : worn) {
            const ColorImage* texture = &one.paint->separation.texture;
            m_textures.push_back({texture, &m_prepared.try_emplace(texture, *texture).first->second});
        }
    }
    const methods::SampleTextures& textures() const { return m_textures; }

private:
    std::map<const ColorImage*, synthesis::SearchTexture> m_prepared;
    methods::SampleTextures m_textures;
};

class ImageBasedPainter : public FramePainter {
public:
    ImageBasedPainter(const Shot& shot, ShotViews& views)
        : m_shot(shot),
          m_views(views),
          m_samples(shot.worn),
          m_animation([this](int frame, const Task& task) { return m_views.at(frame, task); },
                      m_samples.textures(), shot.project.imageBased, shot.project.coherence) {}

    Rendering paint(int frame, const Task& task) override {
        const auto begin = std::chrono::steady_clock::now();
        const methods::ImageBasedTexture texture = m_animation.texture(frame, task.part(0, 0.8));
        const double seconds = secondsSince(begin);
        const methods::FrameView view = m_views.at(frame, task.part(0.8, 0.9));
        return {methods::shadeImageBased(*view.gbuffer, gradientsOf(m_shot.worn), texture, task.part(0.9, 1)),
                texture.report, seconds};
    }

private:
    const Shot& m_shot;
    ShotViews& m_views;
    PreparedTextures m_samples;
    methods::ImageBasedAnimation m_animation;
};

}  // namespace

Rendering renderImageBased(const Project& project, const WornPaints& worn, const scene::GBuffer& gbuffer,
                           const Task& task) {
    const auto begin = std::chrono::steady_clock::now();
    const PreparedTextures samples(worn);
    const methods::ImageBasedTexture texture =
        methods::synthesizeImageBased(gbuffer, samples.textures(), project.imageBased, task.part(0, 0.9));
    const double seconds = secondsSince(begin);
    return {methods::shadeImageBased(gbuffer, gradientsOf(worn), texture, task.part(0.9, 1)), texture.report,
            seconds};
}

std::unique_ptr<FramePainter> animateImageBased(const Shot& shot, ShotViews& views) {
    return std::make_unique<ImageBasedPainter>(shot, views);
}

nlohmann::json imageBasedParameters(const Project& project) {
    nlohmann::json json = parametersToJson(project.imageBased);
    json.update(parametersToJson(project.imageBased.quilt));
    return json;
}

}  // namespace chiaro::project
