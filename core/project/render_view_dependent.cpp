#include "core/project/render_view_dependent.h"

#include <nlohmann/json.hpp>

namespace chiaro::project {

namespace {

/// The surface keeps its texture, so a frame is a picture of its view.
class ViewDependentPainter : public FramePainter {
public:
    ViewDependentPainter(const Shot& shot, ShotViews& views) : m_shot(shot), m_views(views) {}

    Rendering paint(int frame, const Task& task) override {
        const methods::FrameView view = m_views.at(frame, task.part(0, 0.5));
        return renderViewDependent(m_shot.project, m_shot.worn, *view.gbuffer, task.part(0.5, 1));
    }

private:
    const Shot& m_shot;
    ShotViews& m_views;
};

}  // namespace

Rendering renderViewDependent(const Project& project, const WornPaints& worn, const scene::GBuffer& gbuffer,
                              const Task& task) {
    std::vector<methods::ViewDependentPaint> paints;
    for (const Worn& one : worn)
        paints.push_back(
            {one.views.get(), &one.paint->shown, glm::vec3(one.worldToObject * glm::vec4(gbuffer.eye, 1))});
    return {methods::renderViewDependent(gbuffer, paints, project.viewDependent, task), {}, 0};
}

std::unique_ptr<FramePainter> animateViewDependent(const Shot& shot, ShotViews& views) {
    return std::make_unique<ViewDependentPainter>(shot, views);
}

nlohmann::json viewDependentParameters(const Project& project) {
    nlohmann::json json = parametersToJson(project.levels);
    json.update(parametersToJson(project.levels.quilt));
    json.update(parametersToJson(project.views));
    json.update(parametersToJson(project.viewDependent));
    json["up"] = {project.views.up.x, project.views.up.y, project.views.up.z};
    return json;
}

}  // namespace chiaro::project
