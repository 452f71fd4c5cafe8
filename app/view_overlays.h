#pragma once

#include "app/face_groups.h"
#include "widgets/viewport/overlay_views.h"

#include <QObject>

class QAction;

namespace chiaro::widgets {
class Viewport;
}

namespace chiaro::app {

class Meshes;
class ViewPlanningDock;
class ViewPlans;

/// Marks the current object's views, and the faces that their first pass left, over the viewport, and shows
/// all objects' faces in the colours of their views. Three switches, for the View menu and the dock; what
/// they were is remembered.
class ViewOverlays : public QObject {
    Q_OBJECT

public:
    /// The overlay belongs to the viewport.
    ViewOverlays(ViewPlanningDock& dock, JobRunner& jobs, ViewPlans& plans, Meshes& meshes,
                 widgets::Viewport& viewport, QObject* parent);

    /// View frames, uncovered faces, face groups.
    QList<QAction*> actions() const { return {m_frames, m_faces, m_groups}; }
    const FaceGroups& faceGroups() const { return m_faceGroups; }
    widgets::OverlayViews* overlay() const { return m_overlay; }

private:
    QAction* makeAction(const char* icon, const QString& text, const QString& tooltip, const char* key);
    void show();

    ViewPlanningDock& m_dock;
    ViewPlans& m_plans;
    Meshes& m_meshes;
    FaceGroups m_faceGroups;
    widgets::OverlayViews* m_overlay = nullptr;
    QAction* m_frames = nullptr;
    QAction* m_faces = nullptr;
    QAction* m_groups = nullptr;
};

}  // namespace chiaro::app
