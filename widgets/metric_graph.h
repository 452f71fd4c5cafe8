#pragma once

#include "core/metrics/line_chart.h"

#include <QColor>
#include <QWidget>

#include <optional>
#include <vector>

namespace chiaro::widgets {

/// A chart of curves whose values are read by pointing: the pointer picks the nearest x at which a curve has
/// a point, and a note tells every curve's value there. Left and Right move on from point to point, Return
/// takes the one that is picked, as a click does. Standard errors lie as bands around the curves.
class MetricGraph : public QWidget {
    Q_OBJECT

public:
    explicit MetricGraph(QWidget* parent = nullptr);
    ~MetricGraph() override;

    /// Curves keep the colour of their place among the series. `unit` follows a picked x: "45°"; `kind` goes
    /// before it: "Frame 3".
    void setChart(const metrics::LineChart& chart, const QString& kind = {}, const QString& unit = {});
    const metrics::LineChart& chart() const;
    /// Where the y axis ends at least, so that charts beside each other can be compared.
    void setMost(double y);

    /// Picks an x from outside, as the pointer would, without telling so.
    void pick(std::optional<double> x);
    std::optional<double> picked() const;
    /// What the note says, a line a curve; empty while nothing is picked.
    QString note() const;

    static QColor color(std::size_t series);

    QSize sizeHint() const override { return {320, 220}; }
    QSize minimumSizeHint() const override { return {170, 130}; }

Q_SIGNALS:
    void pickedChanged(std::optional<double> x);  ///< by pointer or key; none when the pointer leaves
    void clicked(double x);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    class View;
    View* m_view = nullptr;
};

}  // namespace chiaro::widgets
