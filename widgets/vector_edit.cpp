#include "widgets/vector_edit.h"

#include "widgets/tool_button.h"
#include "widgets/wheel_guard.h"

#include <QtWidgets>

namespace chiaro::widgets {

namespace {

/// A number without the noughts at its end: three fields share the width of a dock.
class ShortNumber : public QDoubleSpinBox {
public:
    QString textFromValue(double value) const override {
        const double least = 0.5 * std::pow(10, -decimals());
        return locale()
            .toString(std::abs(value) < least ? 0.0 : value, 'f', decimals())
            .remove(QRegularExpression("[.,]?0+$"));
    }
};

}  // namespace

VectorEdit::VectorEdit(const Spec& spec, QWidget* parent) : QWidget(parent), m_spec(spec) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    static const std::array<const char*, 3> axes{"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = new ShortNumber;
        field->setObjectName(spec.key + "-" + axes[std::size_t(axis)]);
        field->setAccessibleName(spec.name + " " + QString(axes[std::size_t(axis)]).toUpper());
        field->setDecimals(spec.decimals);
        field->setRange(spec.minimum, spec.maximum);
        field->setSingleStep(spec.step);
        field->setSuffix(spec.unit);
        field->setKeyboardTracking(false);
        field->setButtonSymbols(QAbstractSpinBox::NoButtons);
        field->setMinimumWidth(44);
        field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        field->setToolTip(tr("%1 along %2; arrow keys and the wheel change it")
                              .arg(spec.name, QString(axes[std::size_t(axis)]).toUpper()));
        WheelGuard::protect(field);
        connect(field, &QDoubleSpinBox::valueChanged, this,
                [this, axis](double value) { edit(axis, value); });
        connect(field, &QDoubleSpinBox::editingFinished, this, &VectorEdit::editFinished);
        m_fields[std::size_t(axis)] = field;
        layout->addWidget(field, 1);
    }
    if (spec.hasLink) {
        m_link = makeToolButton("link", tr("Keep proportions"), tr("Change all three in proportion"));
        m_link->setCheckable(true);
        m_link->setChecked(true);
        layout->addWidget(m_link);
    }
    m_reset = makeToolButton("reset", tr("Reset %1").arg(spec.name), tr("Back to the standard"));
    m_reset->setObjectName(spec.key + "-reset");
    QSizePolicy room = m_reset->sizePolicy();
    room.setRetainSizeWhenHidden(true);
    m_reset->setSizePolicy(room);
    connect(m_reset, &QToolButton::clicked, this, [this] {
        Q_EMIT valueEdited(m_spec.standard);
        Q_EMIT editFinished();
    });
    layout->addWidget(m_reset);
    setValue(spec.standard);
}

void VectorEdit::setValue(glm::vec3 value) {
    m_value = value;
    for (int axis = 0; axis < 3; ++axis) {
        QDoubleSpinBox* field = m_fields[std::size_t(axis)];
        const QSignalBlocker quiet(field);
        field->setValue(double(value[axis]));
    }
    m_reset->setVisible(value != m_spec.standard);
}

void VectorEdit::setStep(double step) {
    for (QDoubleSpinBox* field : m_fields) field->setSingleStep(step);
}

void VectorEdit::edit(int axis, double value) {
    glm::vec3 next = m_value;
    next[axis] = float(value);
    if (m_link && m_link->isChecked() && m_value[axis] != 0)
        next = m_value * float(value / double(m_value[axis]));
    Q_EMIT valueEdited(next);
}

}  // namespace chiaro::widgets
