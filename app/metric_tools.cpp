#include "app/metric_tools.h"

#include "app/docks/metric_graph_dock.h"
#include "app/document.h"
#include "app/heat_maps.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

namespace chiaro::app {

MetricTools::MetricTools(Document& document, JobRunner& jobs, Paints& paints, Meshes& meshes,
                         widgets::Viewport& viewport)
    : m_document(document),
      m_viewport(viewport),
      m_comparison(document, jobs, meshes),
      m_study(jobs, paints),
      m_measures(jobs, paints, [&viewport] { return viewport.snapshots(); }),
      m_heatMaps(new HeatMaps(m_measures, viewport, &viewport)),
      m_dock(new MetricGraphDock(jobs, m_comparison, m_study, m_measures)) {
    m_dock->addSwitches(
        {m_heatMaps->liveAction(), m_heatMaps->similarityAction(), m_heatMaps->shadingAction()});
    connect(m_dock, &MetricGraphDock::cameraWanted, &viewport, &widgets::Viewport::setCamera);
}

void MetricTools::addTo(QMenu& menu) const {
    menu.addActions({m_heatMaps->liveAction(), m_heatMaps->similarityAction(), m_heatMaps->shadingAction()});
}

void MetricTools::addTo(QStatusBar& bar) {
    m_figures = new QLabel;
    m_figures->setContentsMargins(0, 0, 16, 0);
    m_figures->setToolTip(
        tr("The viewport's errors: how little it resembles its strips, and how far its "
           "shades are from the light"));
    bar.addPermanentWidget(m_figures);
    const auto show = [this] { m_figures->setText(figures()); };
    connect(&m_measures, &ViewMeasures::measureChanged, m_figures, show);
    connect(m_heatMaps->liveAction(), &QAction::toggled, m_figures, show);
    show();
}

/// Where several methods are compared each has its own figures beside its picture.
QString MetricTools::figures() const {
    return m_viewport.shownMethods().size() == 1 ? measureText(m_measures) : QString();
}

QString MetricTools::figuresText() const {
    return m_figures ? m_figures->text() : QString();
}

void MetricTools::setSample(int sample) {
    const auto& samples = m_document.project().samples;
    const bool isKnown = sample >= 0 && sample < int(samples.size());
    m_study.setSample(sample,
                      isKnown ? QString::fromStdString(samples[std::size_t(sample)].name) : QString());
}

}  // namespace chiaro::app
