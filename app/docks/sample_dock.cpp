#include "app/docks/sample_dock.h"

#include "app/document.h"
#include "app/paints.h"
#include "widgets/picture.h"
#include "widgets/sample_view.h"
#include "widgets/strip_view.h"
#include "widgets/tool_button.h"

#include <QtWidgets>

#include <algorithm>

namespace chiaro::app {

namespace {

constexpr QSize swatchSize(72, 18);

}  // namespace

SampleDock::SampleDock(Document& document, Paints& paints)
    : Dock("sample-dock", tr("Sample"), new QWidget),
      m_document(document),
      m_paints(paints),
      m_sampleView(new widgets::SampleView),
      m_stripView(new widgets::StripView) {
    auto* layout = new QVBoxLayout(static_cast<QScrollArea*>(widget())->widget());
    layout->setContentsMargins(10, 8, 10, 10);
    layout->setSpacing(10);
    layout->addWidget(makeList());
    layout->addWidget(m_sampleView);
    layout->addWidget(m_stripView);
    layout->addStretch(1);

    connect(m_sampleView, &widgets::SampleView::paramsEdited, this,
            [this](const sample::StripParams& params) { m_document.editStrip(m_current, params); });
    connect(m_sampleView, &widgets::SampleView::editFinished, &document, &Document::finishEdit);
    connect(&document, &Document::changed, this, &SampleDock::applyChange);
    connect(&paints, &Paints::scanChanged, this, &SampleDock::showScan);
    connect(&paints, &Paints::separationChanged, this, &SampleDock::showStrip);
    connect(&paints, &Paints::gradientChanged, this, &SampleDock::showRecoloring);
    takeFiles();
    applyChange({});
}

QWidget* SampleDock::makeList() {
    auto* box = new QWidget;
    m_list = new QListWidget;
    m_list->setObjectName("samples");
    m_list->setAccessibleName(tr("Samples"));
    m_list->setIconSize(swatchSize);
    m_list->setUniformItemSizes(true);
    m_list->setFixedHeight(96);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setTextElideMode(Qt::ElideMiddle);
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->setToolTip(tr("Double-click or F2 renames a sample; scans can be dropped here"));
    auto* add = widgets::makeToolButton("add", tr("Add sample"), tr("Open a strip as a new sample"));
    m_remove = widgets::makeToolButton("remove", tr("Remove sample"), tr("Remove the selected sample"));
    m_wear = widgets::makeToolButton("paint", tr("Paint everything"), tr("Put this sample on all objects"));

    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(2);
    for (QToolButton* button : {add, m_remove, m_wear}) buttons->addWidget(button);
    buttons->addStretch(1);
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_list, 1);
    layout->addLayout(buttons);

    connect(m_list, &QListWidget::currentRowChanged, this, &SampleDock::selectSample);
    connect(m_list, &QListWidget::itemChanged, this, &SampleDock::rename);
    connect(add, &QToolButton::clicked, this, &SampleDock::addWanted);
    connect(m_remove, &QToolButton::clicked, this, [this] { m_document.removeSample(m_current); });
    connect(m_wear, &QToolButton::clicked, this, [this] { m_document.wearEverywhere(m_current); });
    return box;
}

void SampleDock::selectSample(int sample) {
    const int count = int(m_document.project().samples.size());
    sample = std::clamp(sample, std::min(0, count - 1), count - 1);
    if (sample == m_current) return;
    m_current = sample;
    showCurrent();
    Q_EMIT currentSampleChanged(sample);
}

void SampleDock::applyChange(Change change) {
    using Kind = Change::Kind;
    if (change.kind == Kind::Everything || change.kind == Kind::Samples) {
        showList();
        const int kept = change.kind == Kind::Everything ? 0 : m_current;
        m_current = -2;  // whatever is selected now is another sample than before
        selectSample(kept);
    }
    if (change.kind == Kind::Strip && change.index == m_current)
        m_sampleView->setParams(m_document.project().samples[std::size_t(m_current)].strip);
}

void SampleDock::showList() {
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const project::Sample& sample : m_document.project().samples) {
        auto* item = new QListWidgetItem(QString::fromStdString(sample.name), m_list);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    for (int sample = 0; sample < m_list->count(); ++sample) showSwatch(sample);
}

void SampleDock::showCurrent() {
    const QSignalBlocker quiet(m_list);
    m_list->setCurrentRow(m_current);
    m_remove->setEnabled(m_current >= 0);
    m_wear->setEnabled(m_current >= 0);
    if (m_current >= 0) m_sampleView->setParams(m_document.project().samples[std::size_t(m_current)].strip);
    showScan(m_current);
    showStrip(m_current);
}

void SampleDock::showScan(int sample) {
    if (sample != m_current) return;
    const auto scan = sample >= 0 ? m_paints.state(sample).scan : nullptr;
    m_sampleView->setScan(scan ? scan->picture : QImage(),
                          scan ? QSize(scan->image.width(), scan->image.height()) : QSize());
}

void SampleDock::showStrip(int sample) {
    if (sample != m_current) return;
    const auto separated = sample >= 0 ? m_paints.state(sample).separated : nullptr;
    m_stripView->setPictures(separated ? separated->pictures : nullptr);
    if (separated) m_stripView->setRecoloring(m_paints.gradient(sample));
}

void SampleDock::showRecoloring(int sample) {
    showSwatch(sample);
    if (sample == m_current) m_stripView->setRecoloring(m_paints.gradient(sample));
}

void SampleDock::showSwatch(int sample) {
    QListWidgetItem* item = m_list->item(sample);
    if (item == nullptr) return;
    QPixmap swatch(swatchSize * devicePixelRatioF());
    swatch.setDevicePixelRatio(devicePixelRatioF());
    swatch.fill(Qt::transparent);
    const gradient::Gradient gradient = m_paints.gradient(sample);
    if (!gradient.empty()) {
        QPainter painter(&swatch);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(QRect({0, 0}, swatchSize), widgets::toImage(gradient));
    }
    QIcon icon(swatch);
    icon.addPixmap(swatch, QIcon::Selected);  // else the selection would tint the colours
    const QSignalBlocker quiet(m_list);
    item->setIcon(icon);
}

void SampleDock::rename(QListWidgetItem* item) {
    const int sample = m_list->row(item);
    const QString name = item->text().trimmed();
    // Queued: the list is made anew, and its editor is still open.
    QMetaObject::invokeMethod(
        this,
        [this, sample, name] {
            if (sample < int(m_document.project().samples.size()) && !name.isEmpty())
                m_document.renameSample(sample, name.toStdString());
            showList();
            showCurrent();
        },
        Qt::QueuedConnection);
}

}  // namespace chiaro::app
