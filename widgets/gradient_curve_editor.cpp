#include "widgets/gradient_curve_editor.h"

#include "widgets/parameter_form.h"
#include "widgets/speed_curve_plot.h"
#include "widgets/tool_button.h"
#include "widgets/wheel_guard.h"

#include <QtWidgets>

namespace chiaro::widgets {

namespace {

QDoubleSpinBox* makeField(const QString& name, const QString& tooltip) {
    auto* field = new QDoubleSpinBox;
    field->setRange(0, 1);
    field->setDecimals(3);
    field->setSingleStep(0.01);
    field->setKeyboardTracking(false);
    field->setAccessibleName(name);
    field->setToolTip(tooltip);
    WheelGuard::protect(field);
    return field;
}

}  // namespace

GradientCurveEditor::GradientCurveEditor(QWidget* parent)
    : QWidget(parent),
      m_form(makeParameterForm<gradient::GradientParams>()),
      m_plot(new SpeedCurvePlot),
      m_x(makeField(tr("Place on the strip"),
                    tr("The selected point's place on the strip, 0 dark to 1 light"))),
      m_y(makeField(tr("Place on the gradient"), tr("The selected point's place on the gradient, 0 to 1"))),
      m_remove(makeToolButton("remove", tr("Remove point"), tr("Remove the selected point (Delete)"))),
      m_straighten(makeToolButton("straighten", tr("Straighten"), tr("Back to a straight curve"))) {
    m_x->setObjectName("point-x");
    m_y->setObjectName("point-y");
    auto* fields = new QHBoxLayout;
    fields->setSpacing(6);
    fields->addWidget(new QLabel(tr("Strip")));
    fields->addWidget(m_x, 1);
    fields->addSpacing(4);
    fields->addWidget(new QLabel(tr("Gradient")));
    fields->addWidget(m_y, 1);
    fields->addWidget(m_remove);
    fields->addWidget(m_straighten);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_form);
    layout->addWidget(m_plot, 1);
    layout->addLayout(fields);

    connect(m_form, &ParameterForm::valueEdited, this, [this] {
        gradient::GradientParams params = m_params;
        gradient::GradientParams::table().assign(params, m_form->values());
        edit(params);
    });
    connect(m_form, &ParameterForm::editFinished, this, &GradientCurveEditor::editFinished);
    connect(m_plot, &SpeedCurvePlot::curveEdited, this, &GradientCurveEditor::editCurve);
    connect(m_plot, &SpeedCurvePlot::editFinished, this, &GradientCurveEditor::editFinished);
    connect(m_plot, &SpeedCurvePlot::selectionChanged, this, &GradientCurveEditor::showPoint);
    connect(m_x, &QDoubleSpinBox::valueChanged, this, [this](double x) {
        m_plot->moveSelected({float(x), m_plot->selectedPlace().y});
    });
    connect(m_y, &QDoubleSpinBox::valueChanged, this, [this](double y) {
        m_plot->moveSelected({m_plot->selectedPlace().x, float(y)});
    });
    for (QDoubleSpinBox* field : {m_x, m_y})
        connect(field, &QDoubleSpinBox::editingFinished, this, &GradientCurveEditor::editFinished);
    connect(m_remove, &QToolButton::clicked, m_plot, &SpeedCurvePlot::removeSelected);
    connect(m_straighten, &QToolButton::clicked, this, [this] {
        m_plot->select(-1);
        editCurve({});
        Q_EMIT editFinished();
    });
    setSeparation(nullptr);
    showParams();
}

void GradientCurveEditor::setParams(const gradient::GradientParams& params) {
    m_params = params;
    showParams();
}

void GradientCurveEditor::setSeparation(const gradient::Separation* separation) {
    setEnabled(separation != nullptr);
    m_matched = separation != nullptr ? separation->curve : gradient::SpeedCurve{};
    m_plot->setColors(separation != nullptr ? separation->averages : gradient::Gradient{},
                      separation != nullptr ? separation->sorted : gradient::Gradient{});
    showParams();
}

void GradientCurveEditor::edit(const gradient::GradientParams& params) {
    if (params == m_params) return;
    // Turning the matching off goes on from what it found, unless the artist has drawn a curve before.
    const bool takesOver =
        m_params.matchSpeed && !params.matchSpeed && params.curve == gradient::SpeedCurve{};
    m_params = params;
    if (takesOver) m_params.curve = m_matched;
    showParams();
    Q_EMIT paramsEdited(m_params);
}

void GradientCurveEditor::editCurve(const gradient::SpeedCurve& curve) {
    gradient::GradientParams params = m_params;
    params.matchSpeed = false;
    params.curve = curve;
    const bool changed = params != m_params;
    m_params = params;
    showParams();
    if (changed) Q_EMIT paramsEdited(m_params);
}

void GradientCurveEditor::showParams() {
    m_form->setValues(gradient::GradientParams::table().values(m_params));
    m_plot->setCurve(m_params.matchSpeed ? m_matched : m_params.curve);
    showPoint();
}

void GradientCurveEditor::showPoint() {
    const int point = m_plot->selected();
    const auto& points = m_plot->curve().points;
    const bool movable = point > 0 && point + 1 < int(points.size());
    const glm::vec2 place = m_plot->selectedPlace();
    for (QDoubleSpinBox* field : {m_x, m_y}) field->setEnabled(movable);
    m_remove->setEnabled(movable);
    m_straighten->setEnabled(m_plot->curve() != gradient::SpeedCurve{});
    const QSignalBlocker quietX(m_x);
    const QSignalBlocker quietY(m_y);
    m_x->setValue(double(place.x));
    m_y->setValue(double(place.y));
}

}  // namespace chiaro::widgets
