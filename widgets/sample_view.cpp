#include "widgets/sample_view.h"

#include "widgets/crop_canvas.h"
#include "widgets/parameter_form.h"
#include "widgets/tool_button.h"

#include <QtWidgets>

namespace chiaro::widgets {

namespace {

/// The row of the table that has this key, as a form of its own.
ParameterForm* makeForm(const std::string& key) {
    const auto& table = sample::StripParams::table();
    const std::vector<double> defaults = table.values({});
    for (std::size_t i = 0; i < defaults.size(); ++i)
        if (table.specs()[i].key == key) return new ParameterForm({table.specs()[i]}, {defaults[i]});
    return nullptr;
}

}  // namespace

SampleView::SampleView(QWidget* parent)
    : QWidget(parent), m_canvas(new CropCanvas), m_scale(makeForm("scale")) {
    auto* turnBack = makeToolButton("turn-left", tr("Turn left"), tr("Turn the strip a quarter to the left"));
    auto* turnOn =
        makeToolButton("turn-right", tr("Turn right"), tr("Turn the strip a quarter to the right"));
    m_mirror =
        makeToolButton("mirror", tr("Mirror"), tr("Swap left and right, for scans with light on the left"));
    m_mirror->setCheckable(true);
    m_resetCrop = makeToolButton("crop-reset", tr("Whole scan"), tr("Use the whole scan"));

    auto* tools = new QHBoxLayout;
    tools->setSpacing(2);
    tools->addWidget(turnBack);
    tools->addWidget(turnOn);
    tools->addWidget(m_mirror);
    tools->addWidget(m_resetCrop);
    tools->addStretch(1);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_canvas, 1);
    layout->addLayout(tools);
    layout->addWidget(m_scale);

    connect(turnBack, &QToolButton::clicked, this, [this] { turn(-1); });
    connect(turnOn, &QToolButton::clicked, this, [this] { turn(1); });
    connect(m_mirror, &QToolButton::clicked, this, &SampleView::mirror);
    connect(m_resetCrop, &QToolButton::clicked, this, &SampleView::resetCrop);
    connect(m_canvas, &CropCanvas::cropEdited, this, [this](const CropQuad& crop) {
        sample::StripParams params = m_params;
        params.crop = crop;
        edit(params);
    });
    connect(m_canvas, &CropCanvas::editFinished, this, &SampleView::editFinished);
    connect(m_scale, &ParameterForm::valueEdited, this, [this](int, double scale) {
        sample::StripParams params = m_params;
        params.scale = scale;
        edit(params);
    });
    connect(m_scale, &ParameterForm::editFinished, this, &SampleView::editFinished);
    setScan({}, {});
    showParams();
}

void SampleView::setScan(const QImage& picture, QSize scanSize) {
    m_canvas->setScan(picture, scanSize);
    setEnabled(!picture.isNull());
}

void SampleView::setParams(const sample::StripParams& params) {
    m_params = params;
    showParams();
}

void SampleView::turn(int quarters) {
    sample::StripParams params = m_params;
    params.quarterTurns = ((params.quarterTurns + quarters) % 4 + 4) % 4;
    edit(params);
    Q_EMIT editFinished();
}

void SampleView::mirror() {
    sample::StripParams params = m_params;
    params.mirror = !params.mirror;
    edit(params);
    Q_EMIT editFinished();
}

void SampleView::resetCrop() {
    sample::StripParams params = m_params;
    params.crop = sample::StripParams{}.crop;
    edit(params);
    Q_EMIT editFinished();
}

void SampleView::edit(const sample::StripParams& params) {
    if (params == m_params) return;
    m_params = params;
    showParams();
    Q_EMIT paramsEdited(params);
}

void SampleView::showParams() {
    m_canvas->setCrop(m_params.crop);
    // A clockwise turn brings the crop's bottom edge to the strip's left, the next one its right edge.
    const int left = (3 + 3 * m_params.quarterTurns) % 4;
    m_canvas->setDarkEdge(m_params.mirror ? (left + 2) % 4 : left);
    const QSignalBlocker quiet(m_mirror);
    m_mirror->setChecked(m_params.mirror);
    m_resetCrop->setEnabled(m_params.crop != sample::StripParams{}.crop);
    m_scale->setValues(std::array{m_params.scale});
}

}  // namespace chiaro::widgets
