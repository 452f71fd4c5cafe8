#include "widgets/metric_legend.h"

#include "widgets/metric_graph.h"

#include <QtWidgets>

namespace chiaro::widgets {

namespace {

constexpr int dashWidth = 16;
constexpr int dashGap = 6;
constexpr int nameGap = 14;

}  // namespace

MetricLegend::MetricLegend(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setAccessibleName(tr("Curves"));
}

void MetricLegend::setNames(const QStringList& names) {
    m_names = names;
    setAccessibleDescription(names.join(", "));
    updateGeometry();
    update();
}

QSize MetricLegend::sizeHint() const {
    int width = 0;
    for (const QString& name : m_names)
        width += dashWidth + dashGap + fontMetrics().horizontalAdvance(name) + nameGap;
    return {width, fontMetrics().height() + 4};
}

void MetricLegend::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    int left = 0;
    for (int i = 0; i < m_names.size(); ++i) {
        painter.setPen(QPen(MetricGraph::color(std::size_t(i)), 2.5, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(QPointF(left + 2, height() / 2.0), QPointF(left + dashWidth - 2, height() / 2.0));
        painter.setPen(palette().color(QPalette::Text));
        const int width = fontMetrics().horizontalAdvance(m_names[i]);
        painter.drawText(QRect(left + dashWidth + dashGap, 0, width + 2, height()),
                         Qt::AlignVCenter | Qt::AlignLeft, m_names[i]);
        left += dashWidth + dashGap + width + nameGap;
    }
}

}  // namespace chiaro::widgets
