#include "app/docks/light_panel.h"

#include "app/docks/scene_steps.h"
#include "app/document.h"
#include "app/meshes.h"
#include "widgets/parameter_form.h"
#include "widgets/vector_edit.h"

#include <QtWidgets>

namespace chiaro::app {

using widgets::ParameterForm;
using widgets::VectorEdit;

namespace {

/// The numbers of a light that a form shows.
std::vector<ParameterSpec> lightSpecs() {
    return {
        ParameterSpec::choice(
            "light-kind", QT_TRANSLATE_NOOP("Core", "Kind"),
            {QT_TRANSLATE_NOOP("Core", "directional"), QT_TRANSLATE_NOOP("Core", "point")},
            QT_TRANSLATE_NOOP("Core", "Far away in a direction, or at a point in the scene")),
        ParameterSpec::real("intensity", QT_TRANSLATE_NOOP("Core", "Intensity"), "", 0, 4, 0.05,
                            QT_TRANSLATE_NOOP("Core", "How much it gives; lights add up, and L ends at 1")),
        ParameterSpec::boolean(
            "wrap", QT_TRANSLATE_NOOP("Core", "Wrap"),
            QT_TRANSLATE_NOOP("Core", "Light goes around to the far side, (1 + n·l)/2; off: half is dark"))};
}

std::vector<double> valuesOf(const scene::Light& light) {
    return {double(light.kind), double(light.intensity), double(light.wrap)};
}

}  // namespace

LightPanel::LightPanel(Document& document, Meshes& meshes) : m_document(document), m_meshes(meshes) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    m_form = new ParameterForm(lightSpecs(), valuesOf(scene::Light{}));
    m_vectorLabel = new QLabel;
    m_vector = new VectorEdit({.key = "light", .name = tr("Light"), .standard = scene::Light{}.vector});
    auto* row = new QHBoxLayout;
    row->addWidget(m_vectorLabel);
    row->addWidget(m_vector, 1);
    layout->addWidget(m_form);
    layout->addLayout(row);
    connect(m_form, &ParameterForm::valueEdited, this, &LightPanel::edit);
    connect(m_form, &ParameterForm::editFinished, &m_document, &Document::finishEdit);
    connect(m_vector, &VectorEdit::valueEdited, this, [this](glm::vec3 value) {
        if (!isThere()) return;
        const bool isPoint =
            m_document.project().lights[std::size_t(m_light)].kind == scene::Light::Kind::Point;
        if (!isPoint && glm::length(value) == 0) return showLight(m_light);
        m_document.editLight(m_light, value);
    });
    connect(m_vector, &VectorEdit::editFinished, &m_document, &Document::finishEdit);
}

bool LightPanel::isThere() const {
    return m_light < int(m_document.project().lights.size());
}

void LightPanel::showLight(int light) {
    m_light = light;
    const scene::Light& one = m_document.project().lights[std::size_t(light)];
    const bool isPoint = one.kind == scene::Light::Kind::Point;
    m_form->setValues(valuesOf(one));
    m_vectorLabel->setText(isPoint ? tr("Position") : tr("Direction"));
    m_vector->setToolTip(isPoint ? tr("Where the light stands")
                                 : tr("From the scene towards the light; only the direction counts"));
    m_vector->setStep(isPoint ? stepFor(m_meshes.size()) : 0.05);
    m_vector->setValue(one.vector);
}

void LightPanel::edit() {
    if (!isThere()) return;
    std::vector<scene::Light> lights = m_document.project().lights;
    scene::Light& light = lights[std::size_t(m_light)];
    const std::vector<double>& values = m_form->values();
    const auto kind = scene::Light::Kind(int(values[0]));
    if (kind != light.kind) {
        // It goes on shining from the same side.
        const scene::Bounds bounds = scene::boundsOf(m_meshes.scene());
        const float away = 2 * m_meshes.size();
        const glm::vec3 way = light.vector - bounds.center();
        light.vector = kind == scene::Light::Kind::Point ? bounds.center() + light.direction({}) * away
                       : glm::length(way) > 0            ? glm::normalize(way)
                                                         : scene::Light{}.vector;
    }
    light.kind = kind;
    light.intensity = float(values[1]);
    light.wrap = values[2] != 0;
    m_document.editLights(lights, tr("Change Light"));
}

}  // namespace chiaro::app
