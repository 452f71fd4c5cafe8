#include "widgets/metric_row.h"

#include "widgets/metric_axes.h"
#include "widgets/metric_graph.h"

#include <QtWidgets>

#include <algorithm>

namespace chiaro::widgets {

MetricRow::MetricRow(QWidget* parent) : QScrollArea(parent) {
    auto* content = new QWidget;
    m_layout = new QHBoxLayout(content);
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(4);
    setFrameShape(NoFrame);
    setFocusPolicy(Qt::NoFocus);  // its charts take the focus
    setWidgetResizable(true);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(content);
}

void MetricRow::add() {
    auto* graph = new MetricGraph;
    m_layout->addWidget(graph, 1);
    m_graphs.push_back(graph);
    m_isHidden.resize(std::max(m_isHidden.size(), m_graphs.size()), false);
    graph->setHidden(m_isHidden[m_graphs.size() - 1]);
    connect(graph, &MetricGraph::clicked, this, &MetricRow::clicked);
    connect(graph, &MetricGraph::pickedChanged, this, [this, graph](std::optional<double> x) {
        for (MetricGraph* other : m_graphs)
            if (other != graph) other->pick(x);
    });
}

void MetricRow::setCharts(const std::vector<metrics::LineChart>& charts, bool sharesY, const QString& kind,
                          const QString& unit) {
    while (m_graphs.size() > charts.size()) {
        delete m_graphs.back();
        m_graphs.pop_back();
    }
    while (m_graphs.size() < charts.size()) add();
    double most = 0;
    if (sharesY)
        for (const metrics::LineChart& chart : charts) most = std::max(most, mostOf(chart));
    for (std::size_t i = 0; i < charts.size(); ++i) {
        m_graphs[i]->setMost(most);
        m_graphs[i]->setChart(charts[i], kind, unit);
    }
}

void MetricRow::setShown(int chart, bool isShown) {
    m_isHidden.resize(std::max(m_isHidden.size(), std::size_t(chart) + 1), false);
    m_isHidden[std::size_t(chart)] = !isShown;
    if (chart < count()) graph(chart)->setVisible(isShown);
}

std::vector<metrics::LineChart> MetricRow::shownCharts() const {
    std::vector<metrics::LineChart> charts;
    for (std::size_t i = 0; i < m_graphs.size(); ++i)
        if (!m_isHidden[i]) charts.push_back(m_graphs[i]->chart());
    return charts;
}

}  // namespace chiaro::widgets
