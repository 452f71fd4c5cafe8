#include "app/view_overlays.h"

#include "app/docks/view_planning_dock.h"
#include "app/meshes.h"
#include "widgets/tool_button.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

widgets::ViewMarks::Triangle cornersOf(const views::Surface& surface, std::uint32_t face) {
    return {glm::vec3(surface.corner(face, 0)), glm::vec3(surface.corner(face, 1)),
            glm::vec3(surface.corner(face, 2))};
}

}  // namespace

ViewOverlays::ViewOverlays(ViewPlanningDock& dock, JobRunner& jobs, ViewPlans& plans, Meshes& meshes,
                           widgets::Viewport& viewport, QObject* parent)
    : QObject(parent),
      m_dock(dock),
      m_plans(plans),
      m_meshes(meshes),
      m_faceGroups(jobs, plans, viewport, nullptr),
      m_overlay(new widgets::OverlayViews(&viewport)) {
    m_frames = makeAction("view-frames", tr("&View Frames"),
                          tr("Show in the viewport where the object's views are"), "overlay/views");
    m_faces =
        makeAction("later-faces", tr("&Uncovered Faces"),
                   tr("Show in the viewport which faces the first pass leaves, through what hides them"),
                   "overlay/uncovered");
    m_groups = makeAction("face-groups", tr("Face &Groups"),
                          tr("Show in the viewport which view each face belongs to, by its colour"),
                          "overlay/groups");
    connect(&m_faceGroups, &FaceGroups::pictureChanged, m_overlay,
            [this] { m_overlay->setPicture(m_faceGroups.picture()); });
    connect(&dock, &ViewPlanningDock::shownViewsChanged, this, &ViewOverlays::show);
    connect(&viewport, &widgets::Viewport::viewChanged, this,
            [this, &viewport] { m_overlay->setCamera(viewport.camera()); });
    connect(&viewport, &widgets::Viewport::panesChanged, this, [this, &viewport] {
        std::vector<QRectF> places;  // pictures that lie over each other are marked once
        for (const widgets::Pane& pane : viewport.panes())
            if (places.empty() || places.back() != pane.rect) places.push_back(pane.rect);
        m_overlay->setPanes(std::move(places));
    });
    connect(&meshes, &Meshes::sceneChanged, this, &ViewOverlays::show);  // the object may be moved
    m_overlay->setCamera(viewport.camera());
    show();
}

QAction* ViewOverlays::makeAction(const char* icon, const QString& text, const QString& tooltip,
                                  const char* key) {
    auto* action = new QAction(widgets::icon(icon), text, this);
    action->setObjectName(icon);
    action->setCheckable(true);
    action->setChecked(QSettings().value(key, false).toBool());
    action->setToolTip(tooltip);
    connect(action, &QAction::toggled, this, [this, key](bool on) {
        QSettings().setValue(key, on);
        show();
    });
    return action;
}

void ViewOverlays::show() {
    if (!m_frames || !m_faces || !m_groups) return;
    const bool isMarking = m_frames->isChecked() || m_faces->isChecked();
    const bool isWanted = isMarking || m_groups->isChecked();
    m_plans.setWanted(this, isWanted);
    const std::vector<scene::Object> objects = m_meshes.scene().objects;
    const int object = m_dock.currentObject();
    const bool isKnown = object >= 0 && object < int(objects.size()) && m_dock.list().plan();
    m_faceGroups.setWanted(m_groups->isChecked());
    m_overlay->setVisible(isWanted && isKnown);
    if (!isWanted || !isKnown) return;

    widgets::ViewMarks marks;
    marks.transform = objects[std::size_t(object)].transform;
    marks.selected = m_dock.selectedView();
    if (m_frames->isChecked())
        for (const ListedView& listed : m_dock.list().views())
            marks.views.push_back({listed.view, listed.placed >= 0});
    if (m_faces->isChecked()) {
        const methods::PlannedObject& planned = *m_dock.list().plan()->planned;
        for (const views::FaceGroup& group : planned.plan.groups)
            if (group.pass > 1)
                for (const std::uint32_t face : group.faces)
                    marks.laterFaces.push_back(cornersOf(planned.surface, face));
        for (const std::uint32_t face : planned.plan.unreachable)
            marks.unreachableFaces.push_back(cornersOf(planned.surface, face));
    }
    m_overlay->setMarks(std::move(marks));
}

}  // namespace chiaro::app
