#include "widgets/compare_bar.h"

#include <QtWidgets>

namespace chiaro::widgets {

namespace {

using Mode = Composition::Mode;

}  // namespace

CompareBar::CompareBar(QWidget* parent) : QWidget(parent) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 0, 0, 0);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    layout->setSpacing(5);

    m_panes = new QSpinBox;
    m_panes->setObjectName("compare-panes");
    m_panes->setRange(2, int(Composition::mostPanes));
    m_panes->setSuffix(tr(" panes"));
    m_panes->setAccessibleName(tr("Panes side by side"));
    m_panes->setToolTip(tr("How many methods are shown side by side"));
    add(m_panes, Mode::SideBySide);
    connect(m_panes, &QSpinBox::valueChanged, this, &CompareBar::paneCountEdited);

    m_position = addNumber("wipe-position", tr("Wipe position"),
                           tr("How much of the picture the first method fills, in % ([ and ])"), Mode::Wipe);
    m_position->setSuffix(tr(" %"));
    connect(m_position, &QDoubleSpinBox::valueChanged, this,
            [this](double value) { edit(wipedTo(m_composition, m_size, value / 100)); });
    m_angle = addNumber("wipe-angle", tr("Wipe angle"),
                        tr("How far the line is turned, clockwise in degrees (Alt+[ and Alt+])"), Mode::Wipe);
    m_angle->setRange(-180, 180);
    m_angle->setSingleStep(5);
    m_angle->setWrapping(true);
    m_angle->setSuffix(tr("°"));
    connect(m_angle, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        Composition turned = m_composition;
        turned.wipeAngle = value;
        edit(turned);
    });

    m_blendSlider = new QSlider(Qt::Horizontal);
    m_blendSlider->setObjectName("blend-slider");
    m_blendSlider->setRange(0, 100);
    m_blendSlider->setFixedWidth(110);
    m_blendSlider->setAccessibleName(tr("Share of the second method, %"));
    m_blendSlider->setToolTip(tr("How much of the second method is laid over the first, in % ([ and ])"));
    add(m_blendSlider, Mode::Blend);
    m_blend =
        addNumber("blend-amount", tr("Share of the second method"), m_blendSlider->toolTip(), Mode::Blend);
    m_blend->setSuffix(tr(" %"));
    connect(m_blendSlider, &QSlider::valueChanged, this, [this](int value) { m_blend->setValue(value); });
    connect(m_blend, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        Composition blended = m_composition;
        blended.blend = value / 100;
        edit(blended);
    });

    m_gain = addNumber("difference-gain", tr("Gain of the difference"),
                       tr("What the difference of the two pictures is multiplied with, so that little shows "
                          "as well ([ and ])"),
                       Mode::Difference);
    m_gain->setRange(1, Composition::largestGain);
    m_gain->setPrefix(tr("× "));
    connect(m_gain, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        Composition gained = m_composition;
        gained.gain = value;
        edit(gained);
    });
    setComposition({}, {1, 1});
}

void CompareBar::add(QWidget* widget, Mode mode) {
    layout()->addWidget(widget);
    m_fields.emplace_back(widget, mode);
}

QDoubleSpinBox* CompareBar::addNumber(const char* name, const QString& label, const QString& tooltip,
                                      Mode mode) {
    auto* field = new QDoubleSpinBox;
    field->setObjectName(name);
    field->setAccessibleName(label);
    field->setToolTip(tooltip);
    field->setDecimals(0);
    field->setRange(0, 100);
    field->setKeyboardTracking(false);
    add(field, mode);
    return field;
}

void CompareBar::edit(const Composition& composition) {
    if (composition == m_composition) return;
    setComposition(composition, m_size);
    Q_EMIT compositionEdited(composition);
}

void CompareBar::setComposition(const Composition& composition, QSizeF size) {
    m_composition = composition;
    m_size = size;
    for (const auto& [field, mode] : m_fields) field->setVisible(mode == composition.mode);
    setVisible(composition.mode != Mode::Single);
    const auto show = [](auto* field, auto value) {
        const QSignalBlocker quiet(field);
        field->setValue(value);
    };
    show(m_panes, int(std::clamp<std::size_t>(composition.methods.size(), 2, Composition::mostPanes)));
    show(m_position, wipePosition(composition, size) * 100);
    show(m_angle, composition.wipeAngle);
    show(m_blendSlider, int(std::lround(composition.blend * 100)));
    show(m_blend, composition.blend * 100);
    show(m_gain, composition.gain);
}

}  // namespace chiaro::widgets
