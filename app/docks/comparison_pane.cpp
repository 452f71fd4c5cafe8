#include "app/docks/comparison_pane.h"

#include "app/method_comparison.h"
#include "core/project/comparison_report.h"
#include "widgets/core_text.h"
#include "widgets/folding_row.h"
#include "widgets/metric_legend.h"
#include "widgets/metric_row.h"

#include <QtWidgets>

#include <utility>

namespace chiaro::app {

ComparisonPane::ComparisonPane(MethodComparison& comparison, QWidget* parent)
    : QWidget(parent),
      m_comparison(comparison),
      m_legend(new widgets::MetricLegend),
      m_row(new widgets::MetricRow),
      m_hint(new QLabel(tr("Measure to see how every method does, frame by frame."))) {
    m_hint->setProperty("note", true);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 6, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(new widgets::FoldingRow(makeSwitches(), m_legend));
    layout->addWidget(m_row, 1);
    layout->addWidget(m_hint, 1);
    connect(m_row, &widgets::MetricRow::clicked, this,
            [this](double frame) { Q_EMIT frameClicked(int(std::lround(frame))); });
    connect(&comparison, &MethodComparison::changed, this, &ComparisonPane::show);
    show();
}

QWidget* ComparisonPane::makeSwitches() {
    auto* switches = new QWidget;
    auto* layout = new QHBoxLayout(switches);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    int chart = 0;
    for (const FrameChart& kind : frameChartKinds()) {
        auto* button = new QToolButton;
        button->setObjectName(QString("chart-%1").arg(chart));
        button->setText(widgets::coreText(kind.label));
        button->setToolTip(widgets::coreText(kind.tooltip));
        button->setCheckable(true);
        button->setChecked(true);
        button->setAutoRaise(true);
        connect(button, &QToolButton::toggled, this,
                [this, chart](bool isOn) { m_row->setShown(chart, isOn); });
        layout->addWidget(button);
        ++chart;
    }
    return switches;
}

MetricSheet ComparisonPane::sheet() const {
    if (!m_comparison.result()) return {};
    MetricSheet sheet;
    sheet.csv = project::framesCsv(m_comparison.result()->table);
    sheet.charts = m_row->shownCharts();
    sheet.columns = 1;  // each has a scale of its own
    return sheet;
}

void ComparisonPane::show() {
    const auto result = m_comparison.result();
    if (result && std::exchange(m_shown, result) == result) return;
    m_shown = result;
    m_hint->setVisible(!result);
    m_row->setVisible(result != nullptr);
    QStringList names;
    if (result) {
        m_row->setCharts(frameCharts(result->table), false, tr("Frame"));
        for (const metrics::Series& series : m_row->shownCharts().empty()
                                                 ? std::vector<metrics::Series>{}
                                                 : m_row->shownCharts().front().series)
            names << widgets::coreText(series.name);
    }
    m_legend->setNames(names);
}

}  // namespace chiaro::app
