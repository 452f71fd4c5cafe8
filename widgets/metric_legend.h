#pragma once

#include <QStringList>
#include <QWidget>

namespace chiaro::widgets {

/// The names of curves in the colours that MetricGraph draws them in, in one line.
class MetricLegend : public QWidget {
    Q_OBJECT

public:
    explicit MetricLegend(QWidget* parent = nullptr);

    void setNames(const QStringList& names);
    const QStringList& names() const { return m_names; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {40, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QStringList m_names;
};

}  // namespace chiaro::widgets
