#pragma once

#include "app/distortion_study.h"
#include "app/method_comparison.h"
#include "app/view_measures.h"

#include <QObject>

class QLabel;
class QMenu;
class QStatusBar;

namespace chiaro::widgets {
class Viewport;
}

namespace chiaro::app {

class Document;
class HeatMaps;
class JobRunner;
class Meshes;
class MetricGraphDock;
class Paints;

/// All of the studio that measures (§5), put together: what the viewport shows, live and as heat maps over
/// it; the comparison of the methods; the study of distortions; and the dock that shows them.
class MetricTools : public QObject {
    Q_OBJECT

public:
    MetricTools(Document& document, JobRunner& jobs, Paints& paints, Meshes& meshes,
                widgets::Viewport& viewport);

    /// Belongs to the window that takes it.
    MetricGraphDock& dock() { return *m_dock; }
    HeatMaps& heatMaps() { return *m_heatMaps; }
    ViewMeasures& viewMeasures() { return m_measures; }
    MethodComparison& comparison() { return m_comparison; }
    DistortionStudy& study() { return m_study; }

    /// The switches of what lies over the viewport.
    void addTo(QMenu& menu) const;
    /// The figures of what the viewport shows.
    void addTo(QStatusBar& bar);
    QString figuresText() const;

public Q_SLOTS:
    /// The sample that the artist works on; -1: none.
    void setSample(int sample);

private:
    QString figures() const;

    Document& m_document;
    widgets::Viewport& m_viewport;
    MethodComparison m_comparison;
    DistortionStudy m_study;
    ViewMeasures m_measures;
    HeatMaps* m_heatMaps = nullptr;
    MetricGraphDock* m_dock = nullptr;
    QLabel* m_figures = nullptr;
};

}  // namespace chiaro::app
