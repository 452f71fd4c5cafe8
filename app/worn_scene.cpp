#include "app/worn_scene.h"

#include "core/project/render_method.h"

#include <algorithm>

namespace chiaro::app {

bool isWorn(const scene::Scene& scene, int sample) {
    return std::ranges::any_of(scene.objects, [&](const scene::Object& object) {
        return object.visible && object.sample == sample;
    });
}

WornScene::WornScene(const PictureSource& source, const Task& task) : m_paints(source.paints.size()) {
    m_bare.shown = {glm::vec3(0.1F), glm::vec3(0.9F)};
    m_bare.separation.texture = ColorImage(64, 64);
    m_bare.levels.levels = {ColorImage(64, 64)};
    for (const scene::Object& object : source.scene.objects) {
        const bool isPainted = std::size_t(object.sample) < m_paints.size();
        m_worn.push_back({isPainted ? &m_paints[std::size_t(object.sample)] : &m_bare, nullptr,
                          glm::inverse(object.transform)});
    }
    if (project::renderMethod(source.project.method).usesViews)
        wearTextures(source, task);
    else
        wearPaints(source, task);
}

void WornScene::wearTextures(const PictureSource& source, const Task& task) {
    for (std::size_t i = 0; i < m_paints.size(); ++i) m_paints[i].shown = source.paints[i].gradient;
    const double share = 1 / double(std::max<std::size_t>(m_worn.size(), 1));
    for (std::size_t i = 0; i < m_worn.size(); ++i) {
        const scene::Object& object = source.scene.objects[i];
        project::Worn& one = m_worn[i];
        if (i < source.objectTextures.size()) one.views = source.objectTextures[i];
        if (one.paint == &m_bare || !object.visible || !object.mesh) continue;
        const Task part = task.part(share * double(i), share * double(i + 1));
        project::Paint& paint = m_paints[std::size_t(object.sample)];
        if (paint.shown.empty() || (!one.views && paint.strip.empty()))
            paint =
                project::separatePaint(source.project.samples[std::size_t(object.sample)], part.part(0, 0.1));
        if (!one.views)
            one.views = project::paintObject(
                source.project, project::planObject(source.project, source.scene, i, part.part(0.1, 0.3)),
                paint, part.part(0.3, 1));
    }
}

void WornScene::wearPaints(const PictureSource& source, const Task& task) {
    const bool usesLevels = project::renderMethod(source.project.method).usesLevels;
    const double share = 1 / double(std::max<std::size_t>(m_paints.size(), 1));
    for (std::size_t i = 0; i < m_paints.size(); ++i) {
        const PicturePaint& made = source.paints[i];
        if (!isWorn(source.scene, int(i))) continue;
        if (usesLevels && made.levels && !made.gradient.empty()) {
            m_paints[i].levels = *made.levels;
            m_paints[i].shown = made.gradient;
        } else {
            m_paints[i] =
                project::preparePaint(source.project, i, task.part(share * double(i), share * double(i + 1)));
        }
    }
}

}  // namespace chiaro::app
