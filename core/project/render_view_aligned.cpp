#include "core/project/render_view_aligned.h"

#include <nlohmann/json.hpp>

namespace chiaro::project {

namespace {

using Placements = std::vector<methods::TexturePlacement>;

Rendering painted(const Project& project, const WornPaints& worn, const Placements& placements,
                  const scene::GBuffer& gbuffer, const Task& task) {
    std::vector<methods::ViewAlignedPaint> paints;
    for (std::size_t i = 0; i < worn.size(); ++i)
        paints.push_back({&worn[i].paint->levels, &worn[i].paint->shown, placements[i]});
    return {methods::renderViewAligned(gbuffer, paints, project.viewAligned, task), {}, 0};
}

/// Lets the texture follow the objects from frame to frame.
class ViewAlignedPainter : public FramePainter {
public:
    ViewAlignedPainter(const Shot& shot, ShotViews& views) : m_shot(shot), m_views(views) {}

    Rendering paint(int frame, const Task& task) override {
        followTo(frame, task);
        const methods::FrameView view = m_views.at(frame, task.part(0, 0.5));
        return painted(m_shot.project, m_shot.worn, m_placements, *view.gbuffer, task.part(0.5, 1));
    }

private:
    void followTo(int frame, const Task& task) {
        if (m_frame == 0 || m_frame > frame) {
            m_frame = 1;
            m_placements.assign(m_shot.worn.size(), {});
        }
        for (; m_frame < frame; ++m_frame) {
            task.checkpoint();
            const scene::Camera before = m_shot.view(m_frame).camera, after = m_shot.view(m_frame + 1).camera;
            if (before == after) continue;
            for (std::size_t i = 0; i < m_placements.size(); ++i) {
                const scene::Object& object = m_shot.scene.objects[i];
                m_placements[i] = methods::follow(m_placements[i], *object.mesh, viewOf(object, before),
                                                  viewOf(object, after), m_shot.project.viewAligned);
            }
        }
    }

    methods::ObjectView viewOf(const scene::Object& object, const scene::Camera& camera) const {
        return {camera.view() * object.transform, camera.projection(m_shot.width, m_shot.height),
                m_shot.width, m_shot.height};
    }

    const Shot& m_shot;
    ShotViews& m_views;
    int m_frame = 0;  ///< that the placements are of; 0 before the first
    Placements m_placements;
};

}  // namespace

Rendering renderViewAligned(const Project& project, const WornPaints& worn, const scene::GBuffer& gbuffer,
                            const Task& task) {
    return painted(project, worn, Placements(worn.size()), gbuffer, task);
}

std::unique_ptr<FramePainter> animateViewAligned(const Shot& shot, ShotViews& views) {
    return std::make_unique<ViewAlignedPainter>(shot, views);
}

nlohmann::json viewAlignedParameters(const Project& project) {
    nlohmann::json json = parametersToJson(project.levels);
    json.update(parametersToJson(project.levels.quilt));
    json.update(parametersToJson(project.viewAligned));
    return json;
}

}  // namespace chiaro::project
