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
    connect(&viewport, &widgets::Viewport::panesChanged, m_overlay,
            [this, &viewport] { m_overlay->setPanes(viewport.panes()); });
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
    const auto maps = m_measures.heatMaps();
    const bool hasMap = !maps.empty();
    m_overlay->setMaps(maps);
    const bool isComing = !m_measures.isMapFinal() && m_measures.problem().isEmpty();
    m_overlay->setProgress(hasMap ? tr("refining…") : tr("measuring…"),
                           isComing ? m_measures.mapProgress() : std::nullopt);
}

QString measureText(const ViewMeasures& measures) {
    return measures.measure() ? measureTexts(measures, 0).join(" · ") : QString();
}

QStringList measureTexts(const ViewMeasures& measures, std::size_t picture) {
    if (!measures.isLive() || !measures.problem().isEmpty()) return {};
    const auto measure = measures.measure(picture);
    const auto figure = [](double value) { return QString::number(value, 'f', 3); };
    const QString waiting = HeatMaps::tr("…");
    QStringList texts{
        HeatMaps::tr("similarity %1").arg(measure ? figure(measure->similarity.mean) : waiting)};
    if (!measure || measure->shadingAbsolute)
        texts << HeatMaps::tr("shading %1").arg(measure ? figure(measure->shadingAbsolute->mean) : waiting);
    return texts;
}

}  // namespace chiaro::app
