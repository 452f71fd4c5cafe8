#pragma once

#include "app/change.h"
#include "app/docks/dock.h"

namespace chiaro::widgets {
class ColorPathView;
class GradientCurveEditor;
}  // namespace chiaro::widgets

namespace chiaro::app {

class Document;
class Paints;

/// The selected sample's gradient: how it is found, and the colours that replace it.
class GradientDock : public Dock {
    Q_OBJECT

public:
    GradientDock(Document& document, Paints& paints);

    void setSample(int sample);
    widgets::GradientCurveEditor* curveEditor() const { return m_editor; }
    widgets::ColorPathView* colorView() const { return m_colors; }

private:
    void applyChange(Change change);
    void showSeparation(int sample);

    Document& m_document;
    Paints& m_paints;
    widgets::GradientCurveEditor* m_editor = nullptr;
    widgets::ColorPathView* m_colors = nullptr;
    int m_sample = -1;
};

}  // namespace chiaro::app
