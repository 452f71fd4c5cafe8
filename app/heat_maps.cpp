#include "app/heat_maps.h"

#include "widgets/tool_button.h"
#include "widgets/viewport/heat_overlay.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

const char* const liveKey = "metrics/live";

}  // namespace

HeatMaps::HeatMaps(ViewMeasures& measures, widgets::Viewport& viewport, QObject* parent)
    : QObject(parent), m_measures(measures), m_overlay(new widgets::HeatOverlay) {
    viewport.addOverlay(m_overlay);
    m_overlay->hide();
    m_live = makeAction("measure", tr("&Live Metrics"),
                        tr("Measure what the viewport shows whenever it comes to rest"));
    m_similarity = makeAction("heat-similarity", tr("Similarity &Heat Map"),
                              tr("Show in the viewport how little each pixel resembles the strip"));
    m_shading = makeAction("heat-shading", tr("Sha&ding Heat Map"),
                           tr("Show in the viewport how far each pixel's shade is from its light"));
    connect(m_live, &QAction::toggled, this, [this](bool isOn) {
        QSettings().setValue(liveKey, isOn);
        m_measures.setLive(isOn);
    });
    connect(m_similarity, &QAction::toggled, this,
            [this](bool isOn) { chooseMap(ViewMeasures::Map::Similarity, isOn); });
    connect(m_shading, &QAction::toggled, this,
            [this](bool isOn) { chooseMap(ViewMeasures::Map::Shading, isOn); });
    connect(&viewport, &widgets::Viewport::pictureChanged, &measures, &ViewMeasures::restart);
    connect(&measures, &ViewMeasures::mapChanged, this, &HeatMaps::show);
    connect(&measures, &ViewMeasures::measureChanged, this, &HeatMaps::show);
    m_live->setChecked(QSettings().value(liveKey, true).toBool());
    measures.setLive(m_live->isChecked());
}

QAction* HeatMaps::makeAction(const char* icon, const QString& text, const QString& tooltip) {
    auto* action = new QAction(widgets::icon(icon), text, this);
    action->setObjectName(icon);
    action->setCheckable(true);
    action->setToolTip(tooltip);
    return action;
}

/// One map at a time, or none.
void HeatMaps::chooseMap(ViewMeasures::Map map, bool isOn) {
    QAction* other = map == ViewMeasures::Map::Similarity ? m_shading : m_similarity;
    if (isOn) {
        const QSignalBlocker quiet(other);
        other->setChecked(false);
    }
    m_measures.setMap(isOn ? map : ViewMeasures::Map::None);
    show();
}

void HeatMaps::show() {
    const bool isWanted = m_measures.map() != ViewMeasures::Map::None;
    m_overlay->setVisible(isWanted);
    if (!isWanted) return;
    const auto map = m_measures.heatMap();
    m_overlay->setMap(map);
    const bool isComing = !m_measures.isMapFinal() && m_measures.problem().isEmpty();
    m_overlay->setProgress(map ? tr("refining…") : tr("measuring…"),
                           isComing ? m_measures.mapProgress() : std::nullopt);
}

QString measureText(const ViewMeasures& measures) {
    const auto& measure = measures.measure();
    if (!measures.isLive() || !measure) return {};
    const QString similarity = HeatMaps::tr("similarity %1").arg(measure->similarity.mean, 0, 'f', 3);
    if (!measure->shadingAbsolute) return similarity;
    return HeatMaps::tr("%1 · shading %2").arg(similarity).arg(measure->shadingAbsolute->mean, 0, 'f', 3);
}

}  // namespace chiaro::app
