#pragma once

#include "app/view_measures.h"

#include <QObject>

class QAction;

namespace chiaro::widgets {
class HeatOverlay;
class Viewport;
}  // namespace chiaro::widgets

namespace chiaro::app {

/// Lays the maps of ViewMeasures over the viewport. Three switches for the View menu and the dock: live
/// figures, and one of the two maps; which are on is remembered.
class HeatMaps : public QObject {
    Q_OBJECT

public:
    /// The overlay belongs to the viewport.
    HeatMaps(ViewMeasures& measures, widgets::Viewport& viewport, QObject* parent);

    QAction* liveAction() const { return m_live; }
    QAction* similarityAction() const { return m_similarity; }
    QAction* shadingAction() const { return m_shading; }
    widgets::HeatOverlay* overlay() const { return m_overlay; }

private:
    QAction* makeAction(const char* icon, const QString& text, const QString& tooltip);
    void chooseMap(ViewMeasures::Map map, bool isOn);
    void show();

    ViewMeasures& m_measures;
    widgets::HeatOverlay* m_overlay = nullptr;
    QAction* m_live = nullptr;
    QAction* m_similarity = nullptr;
    QAction* m_shading = nullptr;
};

/// "similarity 0.083 · shading 0.104", for a status bar; empty while nothing is known.
QString measureText(const ViewMeasures& measures);
/// "similarity 0.083" and "shading 0.104" of one of the pictures that are compared; "…" while they are made.
QStringList measureTexts(const ViewMeasures& measures, std::size_t picture);

}  // namespace chiaro::app
