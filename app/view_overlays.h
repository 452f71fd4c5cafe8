#pragma once

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

/// Marks the current object's views, and the faces that their first pass left, over the viewport. Two
/// switches, for the View menu and the dock; what they were is remembered.
class ViewOverlays : public QObject {
    Q_OBJECT

public:
    /// The overlay belongs to the viewport.
    ViewOverlays(ViewPlanningDock& dock, ViewPlans& plans, Meshes& meshes, widgets::Viewport& viewport,
                 QObject* parent);

    QAction* framesAction() const { return m_frames; }
    QAction* facesAction() const { return m_faces; }
    widgets::OverlayViews* overlay() const { return m_overlay; }

private:
    QAction* makeAction(const char* icon, const QString& text, const QString& tooltip, const char* key);
    void show();

    ViewPlanningDock& m_dock;
    ViewPlans& m_plans;
    Meshes& m_meshes;
    widgets::OverlayViews* m_overlay = nullptr;
    QAction* m_frames = nullptr;
    QAction* m_faces = nullptr;
};

}  // namespace chiaro::app
