#include "app/docks/gradient_dock.h"

#include "app/document.h"
#include "app/paints.h"
#include "widgets/color_path_view.h"
#include "widgets/gradient_curve_editor.h"
#include "widgets/speed_curve_plot.h"

#include <QtWidgets>

#include <optional>

namespace chiaro::app {

GradientDock::GradientDock(Document& document, Paints& paints)
    : Dock("gradient-dock", tr("Gradient Curve"), new QWidget),
      m_document(document),
      m_paints(paints),
      m_editor(new widgets::GradientCurveEditor),
      m_colors(new widgets::ColorPathView) {
    auto* layout = new QVBoxLayout(static_cast<QScrollArea*>(widget())->widget());
    layout->setContentsMargins(10, 8, 10, 10);
    layout->setSpacing(12);
    layout->addWidget(m_editor, 1);
    layout->addWidget(m_colors);

    connect(m_editor, &widgets::GradientCurveEditor::paramsEdited, this,
            [this](const gradient::GradientParams& params) { m_document.editGradient(m_sample, params); });
    connect(m_editor, &widgets::GradientCurveEditor::editFinished, &document, &Document::finishEdit);
    connect(m_colors, &widgets::ColorPathView::recoloringEdited, this,
            [this](const std::optional<gradient::ColorPath>& path) {
                m_document.editRecoloring(m_sample, path);
            });
    connect(m_colors, &widgets::ColorPathView::editFinished, &document, &Document::finishEdit);
    connect(&document, &Document::changed, this, &GradientDock::applyChange);
    connect(&paints, &Paints::separationChanged, this, &GradientDock::showSeparation);
}

void GradientDock::setSample(int sample) {
    m_sample = sample;
    m_editor->plot()->select(-1);
    m_colors->startAfresh();
    m_editor->setParams({});
    if (sample >= 0) {
        const project::Sample& edited = m_document.project().samples[std::size_t(sample)];
        m_editor->setParams(edited.gradient);
        m_colors->setRecoloring(edited.recoloring);
    }
    showSeparation(sample);
}

void GradientDock::applyChange(Change change) {
    if (change.index != m_sample || m_sample < 0) return;
    if (change.kind == Change::Kind::Gradient)
        m_editor->setParams(m_document.project().samples[std::size_t(m_sample)].gradient);
    if (change.kind == Change::Kind::Recoloring)
        m_colors->setRecoloring(m_document.project().samples[std::size_t(m_sample)].recoloring);
}

void GradientDock::showSeparation(int sample) {
    if (sample != m_sample) return;
    const auto separated = sample >= 0 ? m_paints.state(sample).separated : nullptr;
    m_editor->setSeparation(separated ? &separated->separation : nullptr);
    m_colors->setOwnColors(separated ? separated->separation.gradient : gradient::Gradient{});
}

}  // namespace chiaro::app
