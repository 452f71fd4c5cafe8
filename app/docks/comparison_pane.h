#pragma once

#include "app/metric_sheet.h"

#include <QWidget>

#include <memory>

class QLabel;

namespace chiaro::widgets {
class MetricLegend;
class MetricRow;
}  // namespace chiaro::widgets

namespace chiaro::app {

struct Comparison;
class MethodComparison;

/// The errors of every method, frame by frame: a chart an error, of which the artist chooses which to see.
class ComparisonPane : public QWidget {
    Q_OBJECT

public:
    explicit ComparisonPane(MethodComparison& comparison, QWidget* parent = nullptr);

    /// Every error as text, the charts that are shown as pictures.
    MetricSheet sheet() const;
    widgets::MetricRow* row() const { return m_row; }

Q_SIGNALS:
    void frameClicked(int frame);  ///< 1..

private:
    QWidget* makeSwitches();
    void show();

    MethodComparison& m_comparison;
    widgets::MetricLegend* m_legend = nullptr;
    widgets::MetricRow* m_row = nullptr;
    QLabel* m_hint = nullptr;
    std::shared_ptr<const Comparison> m_shown;
};

}  // namespace chiaro::app
