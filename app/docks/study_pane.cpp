#include "app/docks/study_pane.h"

#include "app/distortion_study.h"
#include "widgets/core_text.h"
#include "widgets/folding_row.h"
#include "widgets/metric_legend.h"
#include "widgets/metric_row.h"
#include "widgets/wheel_guard.h"

#include <QtWidgets>

namespace chiaro::app {

StudyPane::StudyPane(DistortionStudy& study, QWidget* parent)
    : QWidget(parent),
      m_study(study),
      m_measure(new QPushButton),
      m_distortions(new QComboBox),
      m_progress(new QProgressBar),
      m_note(new QLabel),
      m_legend(new widgets::MetricLegend),
      m_row(new widgets::MetricRow),
      m_hint(new QLabel(tr("Measure to see how the similarity error answers when a texture is turned, scaled "
                           "or torn: three built-in textures, and the current strip."))) {
    m_hint->setProperty("note", true);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 6, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(new widgets::FoldingRow(makeTools(), m_legend));
    layout->addWidget(m_note);
    layout->addWidget(m_row, 1);
    layout->addWidget(m_hint, 1);
    connect(&study, &DistortionStudy::changed, this, &StudyPane::show);
    connect(&study, &DistortionStudy::progressed, this, &StudyPane::showProgress);
    show();
}

QWidget* StudyPane::makeTools() {
    m_measure->setObjectName("measure-distortions");
    connect(m_measure, &QPushButton::clicked, this,
            [this] { m_study.isRunning() ? m_study.cancel() : m_study.start(); });
    const QStringList names{tr("Rotation"), tr("Scale in x"), tr("Scale in y"), tr("Scale in x and y"),
                            tr("Discontinuity")};
    m_distortions->addItems(names);
    m_distortions->setAccessibleName(tr("Distortion"));
    m_distortions->setToolTip(tr("How the textures are distorted"));
    widgets::WheelGuard::protect(m_distortions);
    connect(m_distortions, &QComboBox::currentIndexChanged, this, &StudyPane::show);
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setFixedSize(120, 6);
    m_note->setProperty("note", true);
    m_note->setWordWrap(true);
    auto* tools = new QWidget;
    auto* layout = new QHBoxLayout(tools);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(m_distortions);
    layout->addWidget(m_measure);
    layout->addWidget(m_progress);
    return tools;
}

metrics::Distortion StudyPane::distortion() const {
    return metrics::allDistortions[std::size_t(std::max(m_distortions->currentIndex(), 0))];
}

QString StudyPane::distortionName() const {
    return metrics::nameOf(distortion());
}

MetricSheet StudyPane::sheet() const {
    if (m_study.points().empty()) return {};
    const std::vector<metrics::LineChart> charts = m_row->shownCharts();
    return {metrics::studyCsv(m_study.points()), {}, charts, int(charts.size())};
}

void StudyPane::show() {
    const bool isKnown = !m_study.points().empty();
    m_hint->setVisible(!isKnown);
    m_row->setVisible(isKnown);
    m_distortions->setEnabled(isKnown);
    const auto charts = studyCharts(m_study.points(), distortion());
    QStringList names;
    if (!charts.empty())
        for (const metrics::Series& series : charts.front().series) names << widgets::coreText(series.name);
    m_legend->setNames(names);
    const bool isTurned = distortion() == metrics::Distortion::Rotation;
    const bool isTorn = distortion() == metrics::Distortion::Discontinuity;
    m_row->setCharts(charts, true,
                     isTorn     ? tr("Blocks of")
                     : isTurned ? tr("Turned by")
                                : tr("Scaled by"),
                     isTorn     ? tr(" px")
                     : isTurned ? tr("°")
                                : QString());
    showProgress();
}

void StudyPane::showProgress() {
    m_measure->setText(m_study.isRunning() ? tr("Cancel") : tr("Measure"));
    m_progress->setVisible(m_study.isRunning());
    m_progress->setValue(int(m_study.progress() * 1000));
    const bool isOutdated = m_study.isOutdated() && !m_study.isRunning();
    m_note->setVisible(isOutdated || !m_study.problem().isEmpty());
    m_note->setText(!m_study.problem().isEmpty() ? m_study.problem()
                    : isOutdated                 ? tr("Of an earlier strip: measure again")
                                                 : QString());
}

}  // namespace chiaro::app
