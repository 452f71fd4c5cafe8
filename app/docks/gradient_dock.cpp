#include "app/docks/gradient_dock.h"

#include "app/document.h"
#include "app/paints.h"
#include "app/preset_menu.h"
#include "widgets/color_path_view.h"
#include "widgets/color_space_plot.h"
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
      m_colors(new widgets::ColorPathView),
      m_plot(new widgets::ColorSpacePlot) {
    auto* layout = new QVBoxLayout(static_cast<QScrollArea*>(widget())->widget());
    layout->setContentsMargins(10, 8, 10, 10);
    layout->setSpacing(12);
    layout->addWidget(m_editor, 1);
    layout->addWidget(m_colors);
    layout->addWidget(m_plot);
    m_colors->addTool(makePresets());

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

QToolButton* GradientDock::makePresets() {
    using project::PresetKind;
    m_presets = new PresetMenu(PresetKind::Gradient, PresetMenu::standardFolder(PresetKind::Gradient),
                               [this]() -> std::optional<project::Preset> {
                                   const gradient::ColorPath path = m_colors->shownPath();
                                   if (m_sample < 0 || path.stops.empty()) return std::nullopt;
                                   return path;
                               });
    connect(m_presets, &PresetMenu::failed, this, &GradientDock::failed);
    connect(m_presets, &PresetMenu::chosen, this, [this](const project::Preset& preset) {
        if (m_sample < 0) return;
        m_document.finishEdit();
        m_document.editRecoloring(m_sample, std::get<gradient::ColorPath>(preset));
        m_document.finishEdit();
    });
    return m_presets->makeButton();
}

void GradientDock::setSample(int sample) {
    m_sample = sample;
    m_editor->plot()->select(-1);
    m_colors->startAfresh();
    m_editor->setParams({});
    m_plot->setPath({}, {});
    if (sample >= 0) {
        m_editor->setParams(m_document.project().samples[std::size_t(sample)].gradient);
        showRecoloring();
    }
    showSeparation(sample);
}

void GradientDock::applyChange(Change change) {
    if (change.index != m_sample || m_sample < 0) return;
    if (change.kind == Change::Kind::Gradient)
        m_editor->setParams(m_document.project().samples[std::size_t(m_sample)].gradient);
    if (change.kind == Change::Kind::Recoloring) showRecoloring();
}

void GradientDock::showRecoloring() {
    const auto& path = m_document.project().samples[std::size_t(m_sample)].recoloring;
    m_colors->setRecoloring(path);
    std::vector<glm::vec3> stops;
    if (path)
        for (const gradient::ColorStop& stop : path->stops) stops.push_back(stop.color);
    constexpr int pathColors = 256;
    m_plot->setPath(path ? path->sampled(pathColors) : std::vector<glm::vec3>{}, stops);
}

void GradientDock::showSeparation(int sample) {
    if (sample != m_sample) return;
    const auto separated = sample >= 0 ? m_paints.state(sample).separated : nullptr;
    m_editor->setSeparation(separated ? &separated->separation : nullptr);
    m_colors->setOwnColors(separated ? separated->separation.gradient : gradient::Gradient{});
    m_plot->setColors(separated ? separated->separation.averages : gradient::Gradient{},
                      separated ? separated->separation.sorted : gradient::Gradient{});
}

}  // namespace chiaro::app
