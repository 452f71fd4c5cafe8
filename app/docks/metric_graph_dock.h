#pragma once

#include "app/docks/dock.h"
#include "app/metric_sheet.h"
#include "core/scene/camera.h"

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QTabWidget;
class QTableView;
class QToolButton;

namespace chiaro::widgets {
class ParameterForm;
}

namespace chiaro::app {

class ComparisonPane;
class ComparisonTable;
class DistortionStudy;
class JobRunner;
class MethodComparison;
class StudyPane;
class ViewMeasures;

/// Which method is better, in figures (§5): what the viewport shows, measured as it is; every method's errors
/// over the frames of an animation; the report's table; and how the metric itself answers to distortions.
class MetricGraphDock : public Dock {
    Q_OBJECT

public:
    MetricGraphDock(JobRunner& jobs, MethodComparison& comparison, DistortionStudy& study,
                    ViewMeasures& measures);

    /// Buttons beside the figures of the viewport.
    void addSwitches(const QList<QAction*>& actions);
    enum class Tab { Frames, Table, Distortions };
    void setTab(Tab tab);
    /// What the tab that is shown would write, and the name it suggests.
    MetricSheet sheet() const;
    QString sheetName() const;
    /// Writes it, in the background; the extension says as what.
    void exportTo(const QString& path);

    ComparisonPane* comparisonPane() const { return m_frames; }
    StudyPane* studyPane() const { return m_distortions; }
    QTableView* table() const { return m_table; }
    widgets::ParameterForm* form() const { return m_form; }

public Q_SLOTS:
    /// Starts the comparison, or cancels the one that runs.
    void measure();
    void exportByDialog();

Q_SIGNALS:
    void frameWanted(int frame);  ///< the artist clicked a frame, 1..
    /// What the comparison saw at that frame.
    void cameraWanted(const chiaro::scene::Camera& camera);
    void exported(const QString& path);

private:
    QWidget* makeSide();
    QWidget* makeTabs();
    void showView();
    void showComparison();
    void showProgress();
    void showExport();
    void wantFrame(int frame);

    JobRunner& m_jobs;
    MethodComparison& m_comparison;
    DistortionStudy& m_study;
    ViewMeasures& m_measures;
    ComparisonTable* m_model = nullptr;

    QLabel* m_similarity = nullptr;
    QLabel* m_shading = nullptr;
    QHBoxLayout* m_switches = nullptr;
    widgets::ParameterForm* m_form = nullptr;
    QPushButton* m_measure = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_note = nullptr;
    QTabWidget* m_tabs = nullptr;
    QToolButton* m_export = nullptr;
    ComparisonPane* m_frames = nullptr;
    QTableView* m_table = nullptr;
    StudyPane* m_distortions = nullptr;
};

}  // namespace chiaro::app
