#pragma once

#include "app/change.h"
#include "app/docks/dock.h"
#include "app/view_list.h"
#include "app/view_thumbnails.h"
#include "core/scene/camera.h"

#include <optional>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QListWidget;
class QToolButton;

namespace chiaro::widgets {
class CoverageBar;
class ParameterForm;
class ViewSphere;
}  // namespace chiaro::widgets

namespace chiaro::app {

class Document;
class Meshes;
class PresetMenu;

/// The views from which an object is painted (§4.3): where they are, what each paints, and what they cover.
/// A planned view that is moved or locked becomes the artist's; planning keeps those and goes on around them
/// by itself after every edit. While the dock can be seen, plans are made whatever the method.
class ViewPlanningDock : public Dock {
    Q_OBJECT

public:
    ViewPlanningDock(Document& document, JobRunner& jobs, Memo& memo, Meshes& meshes, ViewPlans& plans);

    /// The viewport's, for addFromCamera().
    void setCamera(const scene::Camera& camera);
    int currentObject() const { return m_object; }
    void selectObject(int object);
    const ViewList& list() const { return m_list; }
    int selectedView() const;
    void selectView(int view);

    /// Buttons beside the others, for what the viewport shows of the views.
    void addSwitches(const QList<QAction*>& actions);

    PresetMenu* presets() const { return m_presets; }
    widgets::ViewSphere* sphere() const { return m_sphere; }
    widgets::CoverageBar* coverageBar() const { return m_coverage; }

public Q_SLOTS:
    void addFromCamera();
    void lockSelected();
    void removeSelected();

Q_SIGNALS:
    /// Other views, another selection, or another object.
    void shownViewsChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeTools();
    QWidget* makeThumbnails();
    QToolButton* makePresets();
    void connectParts();
    void applyChange(Change change);
    void showObjects();
    void showViews();
    void showSelection();
    void showThumbnails();
    void showStatus();
    QPixmap thumbnail(int view, bool isSelected) const;
    void moveView(int view, const glm::dvec3& direction);
    void lock(int view);
    void remove(int view);
    scene::Camera camera() const;

    Document& m_document;
    JobRunner& m_jobs;
    Meshes& m_meshes;
    ViewPlans& m_plans;
    ViewThumbnails m_pictures;
    ViewList m_list;
    int m_object = -1;
    std::optional<scene::Camera> m_camera;

    QComboBox* m_objects = nullptr;
    widgets::ViewSphere* m_sphere = nullptr;
    QToolButton* m_add = nullptr;
    QToolButton* m_lock = nullptr;
    QToolButton* m_remove = nullptr;
    QToolButton* m_replan = nullptr;
    PresetMenu* m_presets = nullptr;
    QHBoxLayout* m_switches = nullptr;
    QLabel* m_status = nullptr;
    QLabel* m_details = nullptr;
    QListWidget* m_thumbnails = nullptr;
    widgets::CoverageBar* m_coverage = nullptr;
    widgets::ParameterForm* m_form = nullptr;
};

}  // namespace chiaro::app
