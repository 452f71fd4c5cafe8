#include "widgets/parameter_form.h"

#include "widgets/core_text.h"
#include "widgets/tool_button.h"
#include "widgets/wheel_guard.h"

#include <QtWidgets>

#include <algorithm>

namespace chiaro::widgets {

namespace {

/// Beyond this many steps a slider says nothing; a seed has only its number.
constexpr double maximumSliderSteps = 100000;
/// Room for the label and the number; forms below each other align.
constexpr int labelWidth = 92;
constexpr int numberWidth = 112;

/// Digits behind the point that the step needs, and one more for values between steps.
int decimals(const ParameterSpec& spec) {
    if (spec.kind == ParameterSpec::Kind::Integer || spec.step <= 0) return 0;
    return std::clamp(int(std::ceil(-std::log10(spec.step) - 1e-9)), 1, 6);
}

QString capitalised(const std::string& text) {
    QString result = coreText(text);
    if (!result.isEmpty()) result[0] = result[0].toUpper();
    return result;
}

}  // namespace

ParameterForm::ParameterForm(std::vector<ParameterSpec> specs, std::vector<double> defaults, QWidget* parent)
    : QWidget(parent),
      m_specs(std::move(specs)),
      m_defaults(std::move(defaults)),
      m_values(m_defaults),
      m_show(m_specs.size()),
      m_resets(m_specs.size()) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(4);
    grid->setColumnMinimumWidth(0, labelWidth);
    grid->setColumnStretch(2, 1);
    for (int i = 0; i < int(m_specs.size()); ++i) {
        addRow(*grid, i);
        showValue(i, m_values[std::size_t(i)]);
    }
}

void ParameterForm::setValues(std::span<const double> values) {
    for (std::size_t i = 0; i < m_values.size(); ++i) {
        m_values[i] = values[i];
        showValue(int(i), values[i]);
    }
}

void ParameterForm::addRow(QGridLayout& grid, int index) {
    const ParameterSpec& spec = m_specs[std::size_t(index)];
    auto* label = new QLabel(coreText(spec.label));
    QWidget* editor = spec.kind == ParameterSpec::Kind::Boolean  ? makeSwitch(index)
                      : spec.kind == ParameterSpec::Kind::Choice ? makeChoice(index)
                                                                 : makeNumber(index);
    const double standard = m_defaults[std::size_t(index)];
    auto* reset = makeToolButton("reset", tr("Reset %1").arg(label->text()),
                                 tr("Back to %1").arg(valueText(spec, standard)));
    reset->setObjectName(QString::fromStdString(spec.key) + "-reset");
    QSizePolicy room = reset->sizePolicy();
    room.setRetainSizeWhenHidden(true);
    reset->setSizePolicy(room);
    connect(reset, &QToolButton::clicked, this, [this, index, standard] {
        edit(index, standard);
        Q_EMIT editFinished();
    });
    m_resets[std::size_t(index)] = reset;

    label->setToolTip(tooltip(index));
    editor->setToolTip(tooltip(index));
    grid.addWidget(label, index, 0);
    grid.addWidget(reset, index, 1);
    grid.addWidget(editor, index, 2);
}

QWidget* ParameterForm::makeNumber(int index) {
    const ParameterSpec& spec = m_specs[std::size_t(index)];
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    auto* field = new QDoubleSpinBox;
    field->setObjectName(QString::fromStdString(spec.key));
    field->setAccessibleName(coreText(spec.label));
    field->setDecimals(decimals(spec));
    field->setRange(spec.minimum, spec.maximum);
    field->setSingleStep(spec.step > 0 ? spec.step : 1);
    field->setKeyboardTracking(false);
    field->setFixedWidth(numberWidth);
    if (!spec.unit.empty()) field->setSuffix(" " + coreText(spec.unit));
    WheelGuard::protect(field);
    connect(field, &QDoubleSpinBox::valueChanged, this, [this, index](double value) { edit(index, value); });
    connect(field, &QDoubleSpinBox::editingFinished, this, &ParameterForm::editFinished);

    const double step = spec.step > 0 ? spec.step : (spec.maximum - spec.minimum) / 100;
    const double steps = (spec.maximum - spec.minimum) / step;
    QSlider* slider = nullptr;
    if (steps <= maximumSliderSteps) {
        slider = new QSlider(Qt::Horizontal);
        slider->setObjectName(QString::fromStdString(spec.key) + "-slider");
        slider->setAccessibleName(coreText(spec.label));
        slider->setRange(0, int(std::lround(steps)));
        slider->setPageStep(std::max(1, slider->maximum() / 20));
        WheelGuard::protect(slider);
        connect(slider, &QSlider::valueChanged, this, [this, index, step](int position) {
            const ParameterSpec& edited = m_specs[std::size_t(index)];
            edit(index, std::min(edited.minimum + position * step, edited.maximum));
        });
        connect(slider, &QSlider::sliderReleased, this, &ParameterForm::editFinished);
        layout->addWidget(slider, 1);
    } else {
        layout->addStretch(1);
    }
    layout->addWidget(field, 0, Qt::AlignRight);  // also where a narrow form hides sliders

    m_show[std::size_t(index)] = [field, slider, step, minimum = spec.minimum](double value) {
        const QSignalBlocker quietField(field);
        field->setValue(value);
        if (slider == nullptr) return;
        const QSignalBlocker quietSlider(slider);
        slider->setValue(int(std::lround((value - minimum) / step)));
    };
    return row;
}

QWidget* ParameterForm::makeSwitch(int index) {
    const ParameterSpec& spec = m_specs[std::size_t(index)];
    auto* box = new QCheckBox;
    box->setObjectName(QString::fromStdString(spec.key));
    box->setAccessibleName(coreText(spec.label));
    connect(box, &QCheckBox::toggled, this, [this, index](bool on) {
        edit(index, on ? 1 : 0);
        Q_EMIT editFinished();
    });
    m_show[std::size_t(index)] = [box](double value) {
        const QSignalBlocker quiet(box);
        box->setChecked(value != 0);
    };
    return box;
}

QWidget* ParameterForm::makeChoice(int index) {
    const ParameterSpec& spec = m_specs[std::size_t(index)];
    auto* list = new QComboBox;
    list->setObjectName(QString::fromStdString(spec.key));
    list->setAccessibleName(coreText(spec.label));
    for (const std::string& choice : spec.choices) list->addItem(capitalised(choice));
    WheelGuard::protect(list);
    connect(list, &QComboBox::currentIndexChanged, this, [this, index](int choice) {
        edit(index, choice);
        Q_EMIT editFinished();
    });
    m_show[std::size_t(index)] = [list](double value) {
        const QSignalBlocker quiet(list);
        list->setCurrentIndex(int(value));
    };
    return list;
}

void ParameterForm::edit(int index, double value) {
    if (m_values[std::size_t(index)] == value) return;
    m_values[std::size_t(index)] = value;
    showValue(index, value);
    Q_EMIT valueEdited(index, value);
}

void ParameterForm::showValue(int index, double value) {
    m_show[std::size_t(index)](value);
    m_resets[std::size_t(index)]->setVisible(value != m_defaults[std::size_t(index)]);
}

QString ParameterForm::tooltip(int index) const {
    const ParameterSpec& spec = m_specs[std::size_t(index)];
    return tr("%1\nRange %2, default %3")
        .arg(coreText(spec.tooltip), rangeText(spec), valueText(spec, m_defaults[std::size_t(index)]));
}

}  // namespace chiaro::widgets
