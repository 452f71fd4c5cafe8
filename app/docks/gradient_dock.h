#pragma once

#include "app/change.h"
#include "app/docks/dock.h"

class QToolButton;

namespace chiaro::widgets {
class ColorPathView;
class ColorSpacePlot;
class GradientCurveEditor;
}  // namespace chiaro::widgets

namespace chiaro::app {

class Document;
class Paints;
class PresetMenu;

/// The selected sample's gradient: how it is found, the colours that replace it, and both in RGB.
class GradientDock : public Dock {
    Q_OBJECT

public:
    GradientDock(Document& document, Paints& paints);

    void setSample(int sample);
    widgets::GradientCurveEditor* curveEditor() const { return m_editor; }
    widgets::ColorPathView* colorView() const { return m_colors; }
    widgets::ColorSpacePlot* colorSpacePlot() const { return m_plot; }
    PresetMenu* presets() const { return m_presets; }

private:
    void applyChange(Change change);
    void showSeparation(int sample);
    void showRecoloring();
    QToolButton* makePresets();

    Document& m_document;
    Paints& m_paints;
    widgets::GradientCurveEditor* m_editor = nullptr;
    widgets::ColorPathView* m_colors = nullptr;
    widgets::ColorSpacePlot* m_plot = nullptr;
    PresetMenu* m_presets = nullptr;
    int m_sample = -1;
};

}  // namespace chiaro::app
