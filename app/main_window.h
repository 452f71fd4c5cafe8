#pragma once

#include "app/document.h"
#include "app/frame_textures.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/memo.h"
#include "app/meshes.h"
#include "app/object_textures.h"
#include "app/opener.h"
#include "app/paints.h"
#include "app/playback.h"
#include "app/view_plans.h"

#include <QMainWindow>

#include <vector>

class QLabel;

namespace chiaro::widgets {
class MessageBar;
class Viewport;
}  // namespace chiaro::widgets

namespace chiaro::app {

class CompareTools;
class Exporter;
class GradientDock;
class JobsDock;
class MethodSwitch;
class MetricTools;
class ParametersDock;
class ProjectCollector;
class ProjectFiles;
class Safekeeping;
class SampleDock;
class SceneDock;
class ThemeSwitch;
class TimelineDock;
class ViewMenu;
class ViewOverlays;
class ViewPlanningDock;

/// The studio's window: the viewport, the docks around it and the menus. It puts the parts together; each
/// part wires itself to the document.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    MainWindow();
    ~MainWindow() override;

    /// Theme and language, to choose in the View menu.
    void addAppearance(ThemeSwitch& theme);
    void open(const QStringList& paths) { m_opener.open(paths); }
    /// Where docks were and how large the window was when it was closed last.
    void restoreLayout();
    /// Keeps the artist's work, and asks about what is amiss: for a window that somebody sits at. Offers what
    /// a studio that crashed left; true when the artist takes it.
    bool keepWorkSafe();

    Document& document() { return m_document; }
    JobRunner& jobs() { return m_jobs; }
    Paints& paints() { return m_paints; }
    FrameTextures& frameTextures() { return m_frameTextures; }
    ViewPlans& viewPlans() { return m_viewPlans; }
    ObjectTextures& objectTextures() { return m_objectTextures; }
    widgets::Viewport& viewport() { return *m_viewport; }
    widgets::MessageBar& messages() { return *m_messages; }
    SampleDock& sampleDock() { return *m_sampleDock; }
    SceneDock& sceneDock() { return *m_sceneDock; }
    Playback& playback() { return m_playback; }
    TimelineDock& timelineDock() { return *m_timelineDock; }
    JobsDock& jobsDock() { return *m_jobsDock; }
    GradientDock& gradientDock() { return *m_gradientDock; }
    ViewPlanningDock& viewPlanningDock() { return *m_viewsDock; }
    MetricTools& metrics() { return *m_metrics; }
    CompareTools& compare() { return *m_compare; }
    QString frameText() const;  ///< in the status bar: the method and its frame time

public Q_SLOTS:
    void showError(const QString& message);
    void showNote(const QString& message);

Q_SIGNALS:
    void errorShown(const QString& message);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void makeCentralView();
    void makeDocks();
    void makeMetrics();
    void makeBottomDocks();
    /// Docks that lie over each other as tabs, the first of them seen.
    struct DockPlace {
        Qt::DockWidgetArea area;
        std::vector<QDockWidget*> tabs;
    };
    /// Docks go where they are at first, whatever became of them. A saved state of the window would do, but
    /// Qt 6.4 crashes on restoring one into a shown window, once in some thousand events.
    void placeDocks();
    void arrangeDocks();
    void makeToolBar();
    void makeStatusBar();
    void makeMenus();
    void connectParts();
    void showTitle();
    void followTheme();

    // What the window shows, in the order that it depends on each other.
    Document m_document;
    Memo m_memo;
    JobRunner m_jobs;
    Paints m_paints;
    Meshes m_meshes;
    Playback m_playback;
    FrameTextures m_frameTextures;
    ViewPlans m_viewPlans;
    ObjectTextures m_objectTextures;
    Opener m_opener;
    std::unique_ptr<MetricTools> m_metrics;

    MethodSwitch* m_methods = nullptr;
    CompareTools* m_compare = nullptr;
    widgets::MessageBar* m_messages = nullptr;
    widgets::Viewport* m_viewport = nullptr;
    SampleDock* m_sampleDock = nullptr;
    SceneDock* m_sceneDock = nullptr;
    GradientDock* m_gradientDock = nullptr;
    ParametersDock* m_parametersDock = nullptr;
    ViewPlanningDock* m_viewsDock = nullptr;
    TimelineDock* m_timelineDock = nullptr;
    JobsDock* m_jobsDock = nullptr;
    ViewOverlays* m_viewOverlays = nullptr;
    ProjectFiles* m_files = nullptr;
    ProjectCollector* m_collector = nullptr;
    Exporter* m_exporter = nullptr;
    Safekeeping* m_safekeeping = nullptr;
    QLabel* m_frameTime = nullptr;
    ViewMenu* m_viewMenu = nullptr;
    std::vector<DockPlace> m_dockPlaces;
    bool m_isArranged = false;
};

}  // namespace chiaro::app
