#include "app/docks/metric_graph_dock.h"

#include "app/comparison_table.h"
#include "app/distortion_study.h"
#include "app/docks/comparison_pane.h"
#include "app/docks/study_pane.h"
#include "app/jobs/job_runner.h"
#include "app/method_comparison.h"
#include "app/view_measures.h"
#include "core/project/comparison_report.h"
#include "widgets/parameter_form.h"
#include "widgets/tool_button.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr int sideWidth = 264;

QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("heading", true);
    label->setIndent(0);
    return label;
}

/// A measured value with its standard error.
QString figure(const metrics::Estimate& estimate) {
    return MetricGraphDock::tr("%1 ± %2")
        .arg(estimate.mean, 0, 'f', 4)
        .arg(estimate.standardError, 0, 'f', 4);
}

}  // namespace

MetricGraphDock::MetricGraphDock(JobRunner& jobs, MethodComparison& comparison, DistortionStudy& study,
                                 ViewMeasures& measures)
    : Dock("metric-graph-dock", tr("Metric Graph"), new QWidget),
      m_jobs(jobs),
      m_comparison(comparison),
      m_study(study),
      m_measures(measures),
      m_model(new ComparisonTable(this)) {
    auto* layout = new QHBoxLayout(static_cast<QScrollArea*>(widget())->widget());
    layout->setContentsMargins(10, 6, 10, 8);
    layout->setSpacing(14);
    layout->addWidget(makeSide());
    layout->addWidget(makeTabs(), 1);
    connect(&measures, &ViewMeasures::measureChanged, this, &MetricGraphDock::showView);
    connect(&comparison, &MethodComparison::changed, this, &MetricGraphDock::showComparison);
    connect(&comparison, &MethodComparison::progressed, this, &MetricGraphDock::showProgress);
    connect(&study, &DistortionStudy::changed, this, &MetricGraphDock::showExport);
    connect(m_tabs, &QTabWidget::currentChanged, this, &MetricGraphDock::showExport);
    connect(m_frames, &ComparisonPane::frameClicked, this, &MetricGraphDock::wantFrame);
    showView();
    showComparison();
}

/// What the viewport shows, and what methods are compared on.
QWidget* MetricGraphDock::makeSide() {
    auto* side = new QWidget;
    side->setFixedWidth(sideWidth);
    m_similarity = new QLabel;
    m_shading = new QLabel;
    m_similarity->setObjectName("view-similarity");
    m_shading->setObjectName("view-shading");
    m_switches = new QHBoxLayout;
    m_switches->setSpacing(2);
    auto* head = new QHBoxLayout;
    head->addWidget(heading(tr("Viewport")), 1);
    head->addLayout(m_switches);
    auto* figures = new QGridLayout;
    figures->setHorizontalSpacing(10);
    figures->setVerticalSpacing(2);
    figures->setColumnStretch(1, 1);
    figures->addWidget(new QLabel(tr("Similarity error")), 0, 0);
    figures->addWidget(m_similarity, 0, 1, Qt::AlignRight);
    figures->addWidget(new QLabel(tr("Shading error")), 1, 0);
    figures->addWidget(m_shading, 1, 1, Qt::AlignRight);

    m_form = widgets::makeParameterForm<ComparisonSettings>();
    // Numbers to type; sliders would take the charts' room.
    for (QSlider* slider : m_form->findChildren<QSlider*>()) slider->hide();
    m_measure = new QPushButton;
    m_measure->setObjectName("measure-methods");
    connect(m_measure, &QPushButton::clicked, this, &MetricGraphDock::measure);
    m_progress = new QProgressBar;
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(6);
    m_note = new QLabel;
    m_note->setProperty("note", true);
    m_note->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->addWidget(heading(tr("Comparison")), 1);
    row->addWidget(m_measure);

    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(head);
    layout->addLayout(figures);
    layout->addLayout(row);
    layout->addWidget(m_progress);
    layout->addWidget(m_form);
    layout->addWidget(m_note);
    layout->addStretch(1);
    return side;
}

QWidget* MetricGraphDock::makeTabs() {
    m_frames = new ComparisonPane(m_comparison);
    m_distortions = new StudyPane(m_study);
    m_table = new QTableView;
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("Errors of the methods"));
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionsClickable(false);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setSectionsClickable(false);
    m_table->verticalHeader()->setDefaultSectionSize(26);
    m_tabs = new QTabWidget;
    m_tabs->setDocumentMode(true);
    m_tabs->setAccessibleName(tr("Comparison"));
    m_tabs->addTab(m_frames, tr("Frames"));
    m_tabs->addTab(m_table, tr("Table"));
    m_tabs->addTab(m_distortions, tr("Distortions"));
    m_export = widgets::makeToolButton("export", tr("Export figures"),
                                       tr("Write what this tab shows as CSV, Markdown, SVG or PNG"));
    connect(m_export, &QToolButton::clicked, this, &MetricGraphDock::exportByDialog);
    m_tabs->setCornerWidget(m_export);
    return m_tabs;
}

void MetricGraphDock::addSwitches(const QList<QAction*>& actions) {
    for (QAction* action : actions) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setAccessibleName(action->toolTip());
        m_switches->addWidget(button);
        connect(action, &QAction::toggled, this, &MetricGraphDock::showView);
    }
}

void MetricGraphDock::setTab(Tab tab) {
    m_tabs->setCurrentIndex(int(tab));
}

void MetricGraphDock::showView() {
    const auto measure = m_measures.measure();
    const QString none = m_measures.isLive() ? tr("…") : tr("–");
    const bool isShown = m_measures.isLive() && measure;
    m_similarity->setText(isShown ? figure(measure->similarity) : none);
    m_shading->setText(isShown && measure->shadingAbsolute ? figure(*measure->shadingAbsolute) : none);
    const QString why = m_measures.problem();
    m_similarity->setToolTip(!why.isEmpty()
                                 ? why
                                 : tr("How little the picture resembles its strips, at pixels drawn "
                                      "by chance; smaller is better"));
    m_shading->setToolTip(!why.isEmpty() ? why
                                         : tr("How far the shade that the texture is meant for is from the "
                                              "light, 0 to 1; smaller is better"));
}

void MetricGraphDock::measure() {
    if (m_comparison.isRunning()) return m_comparison.cancel();
    ComparisonSettings settings;
    ComparisonSettings::table().assign(settings, m_form->values());
    m_comparison.start(settings);
}

void MetricGraphDock::showComparison() {
    m_model->setMeasures(m_comparison.result() ? m_comparison.result()->table
                                               : std::vector<project::MethodMeasure>{});
    showExport();
    showProgress();
}

void MetricGraphDock::showProgress() {
    const bool isRunning = m_comparison.isRunning();
    m_measure->setText(isRunning ? tr("Cancel") : tr("Measure"));
    m_measure->setEnabled(isRunning || m_comparison.canStart());
    m_form->setEnabled(!isRunning);
    m_progress->setVisible(isRunning);
    m_progress->setValue(int(m_comparison.progress() * 1000));
    QString note = m_comparison.problem();
    if (note.isEmpty() && !m_comparison.canStart()) note = tr("Needs a mesh and a strip of paint");
    if (note.isEmpty() && m_comparison.isOutdated() && !isRunning)
        note = tr("The project has changed since: these figures are of before");
    m_note->setText(note);
    m_note->setVisible(!isRunning && !note.isEmpty());
}

void MetricGraphDock::showExport() {
    const MetricSheet shown = sheet();
    m_export->setEnabled(!shown.csv.empty());
}

MetricSheet MetricGraphDock::sheet() const {
    switch (Tab(m_tabs->currentIndex())) {
        case Tab::Frames:
            return m_frames->sheet();
        case Tab::Distortions:
            return m_distortions->sheet();
        case Tab::Table:
            break;
    }
    if (!m_comparison.result()) return {};
    const auto& measures = m_comparison.result()->table;
    return {project::comparisonCsv(measures), project::comparisonMarkdown(measures), {}, 1};
}

QString MetricGraphDock::sheetName() const {
    switch (Tab(m_tabs->currentIndex())) {
        case Tab::Frames:
            return "frames";
        case Tab::Table:
            return "table";
        case Tab::Distortions:
            break;
    }
    return m_distortions->distortionName();
}

void MetricGraphDock::exportByDialog() {
    const bool hasCharts = !sheet().charts.empty();
    const QString filter =
        hasCharts ? tr("Charts (*.svg *.png);;Table (*.csv)") : tr("Table (*.csv);;Markdown (*.md)");
    QSettings settings;
    const QString folder = settings.value("folder/metrics").toString();
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Export Figures"), QDir(folder).filePath(sheetName() + (hasCharts ? ".svg" : ".csv")),
        filter);
    if (path.isEmpty()) return;
    settings.setValue("folder/metrics", QFileInfo(path).path());
    exportTo(path);
}

void MetricGraphDock::exportTo(const QString& path) {
    m_jobs.start(
        {tr("Exporting %1").arg(QFileInfo(path).fileName()), {}, {}, {}},
        [path = std::filesystem::path(path.toStdString()), sheet = sheet()](const Task&) {
            writeSheet(path, sheet);
            return true;
        },
        [this, path](bool) { Q_EMIT exported(path); });
}

void MetricGraphDock::wantFrame(int frame) {
    if (!m_comparison.result()) return;
    Q_EMIT frameWanted(frame);
    Q_EMIT cameraWanted(m_comparison.result()->path.at(frame, m_comparison.result()->start).camera);
}

}  // namespace chiaro::app
