#pragma once

#include "core/metrics/line_chart.h"

#include <QScrollArea>

#include <vector>

class QHBoxLayout;

namespace chiaro::widgets {

class MetricGraph;

/// Charts side by side that pick the same x together; where that is too narrow they scroll. Those of one
/// measure share the end of their y axes.
class MetricRow : public QScrollArea {
    Q_OBJECT

public:
    explicit MetricRow(QWidget* parent = nullptr);

    /// What `kind` and `unit` are to MetricGraph::setChart(). A chart that was hidden stays so.
    void setCharts(const std::vector<metrics::LineChart>& charts, bool sharesY, const QString& kind = {},
                   const QString& unit = {});
    void setShown(int chart, bool isShown);
    /// Those that are shown, in their order.
    std::vector<metrics::LineChart> shownCharts() const;
    MetricGraph* graph(int chart) const { return m_graphs[std::size_t(chart)]; }
    int count() const { return int(m_graphs.size()); }

    QSize sizeHint() const override { return {480, 150}; }
    QSize minimumSizeHint() const override { return {200, 140}; }

Q_SIGNALS:
    void clicked(double x);

private:
    void add();

    QHBoxLayout* m_layout = nullptr;
    std::vector<MetricGraph*> m_graphs;
    std::vector<bool> m_isHidden;  ///< as far as was told
};

}  // namespace chiaro::widgets
