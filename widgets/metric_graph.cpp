#include "widgets/metric_graph.h"

#include "widgets/core_text.h"
#include "widgets/metric_axes.h"

#include <QtCharts>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace chiaro::widgets {

namespace {

constexpr std::array<QRgb, 6> curveColors{0xff56b4e9, 0xffe9a43c, 0xff3fc79a,
                                          0xffe08fc0, 0xfff0e442, 0xffb0b0b0};
constexpr double dotRadius = 2.4;
constexpr double notePadding = 7;
constexpr double noteGap = 12;
constexpr double noteShare = 0.6;  ///< of a chart's width, at most
constexpr int titledWidth = 260;   ///< narrower charts don't name their y axis

QString valueOf(const metrics::ChartPoint& point) {
    const QString value = QString::number(point.y, 'f', 5);
    return point.error > 0 ? QString("%1 ± %2").arg(value).arg(point.error, 0, 'f', 5) : value;
}

QString lineOf(const metrics::Series& series, const metrics::ChartPoint& point) {
    return QString("%1  %2").arg(coreText(series.name), valueOf(point));
}

}  // namespace

/// The chart itself, and what is drawn over it: the crosshair, its dots and the note.
class MetricGraph::View : public QChartView {
public:
    explicit View(MetricGraph& owner) : QChartView(&owner), m_owner(owner) {
        chart()->legend()->hide();
        chart()->layout()->setContentsMargins(0, 0, 0, 0);
        chart()->setBackgroundRoundness(0);
        chart()->setMargins({4, 2, 10, 2});
        setRenderHint(QPainter::Antialiasing);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus);
        viewport()->setMouseTracking(true);
    }

    void show(const metrics::LineChart& shown, const QString& kind, const QString& unit) {
        m_shown = shown;
        m_kind = kind;
        m_unit = unit;
        m_picked.reset();
        m_xs.clear();
        std::set<double> xs;
        for (const metrics::Series& series : shown.series)
            for (const metrics::ChartPoint& point : series.points) xs.insert(point.x);
        m_xs.assign(xs.begin(), xs.end());
        rebuild();
    }
    void setMost(double most) {
        m_most = most;
        rebuild();
    }
    void rebuild() {
        chart()->removeAllSeries();
        for (QAbstractAxis* axis : chart()->axes()) delete axis;
        m_curves.clear();
        chart()->setTitle(coreText(m_shown.title).toHtmlEscaped());
        QAbstractAxis* x = horizontalAxis(m_shown);
        QAbstractAxis* y = verticalAxis(m_shown, m_most);
        chart()->addAxis(x, Qt::AlignBottom);
        chart()->addAxis(y, Qt::AlignLeft);
        for (std::size_t i = 0; i < m_shown.series.size(); ++i) addCurve(m_shown.series[i], color(i), x, y);
        applyPalette();
        update();
    }
    void applyPalette() {
        const QPalette& palette = m_owner.palette();
        chart()->setBackgroundBrush(palette.color(QPalette::Base));
        setBackgroundBrush(palette.color(QPalette::Base));
        QFont small = m_owner.font();
        small.setPointSizeF(small.pointSizeF() * 0.92);
        QFont bold = m_owner.font();
        bold.setBold(true);
        chart()->setTitleFont(bold);
        chart()->setTitleBrush(palette.color(QPalette::Text));
        for (QAbstractAxis* axis : chart()->axes()) {
            axis->setLabelsFont(small);
            axis->setTitleFont(small);
            axis->setLabelsColor(palette.color(QPalette::PlaceholderText));
            axis->setTitleBrush(palette.color(QPalette::PlaceholderText));
            axis->setLinePenColor(palette.color(QPalette::Disabled, QPalette::Text));
            axis->setGridLineColor(palette.color(QPalette::Button));
            axis->setGridLineVisible(axis->orientation() == Qt::Vertical);
        }
        showTitles();
    }
    void showTitles() {
        for (QAbstractAxis* axis : chart()->axes(Qt::Vertical)) axis->setTitleVisible(width() >= titledWidth);
    }

    void pick(std::optional<double> x, bool tells) {
        if (x == m_picked) return;
        m_picked = x;
        viewport()->update();
        m_owner.setAccessibleDescription(note());
        if (tells) Q_EMIT m_owner.pickedChanged(x);
    }
    /// From point to point; from nowhere to the first or the last.
    void step(int by) {
        if (m_xs.empty()) return;
        auto place = m_picked ? std::ranges::find(m_xs, *m_picked) - m_xs.begin()
                              : (by > 0 ? -1 : std::ptrdiff_t(m_xs.size()));
        place = std::clamp<std::ptrdiff_t>(place + by, 0, std::ptrdiff_t(m_xs.size()) - 1);
        pick(m_xs[std::size_t(place)], true);
    }
    QString heading() const {
        return QStringList{m_kind, QString("%1%2").arg(*m_picked, 0, 'g', 4).arg(m_unit)}.join(
            m_kind.isEmpty() ? "" : " ");
    }
    QString note() const {
        if (!m_picked) return {};
        QStringList lines{heading()};
        for (const metrics::Series& series : m_shown.series)
            if (const auto* point = pointAt(series)) lines << lineOf(series, *point);
        return lines.join('\n');
    }

    const metrics::LineChart& shown() const { return m_shown; }
    const std::optional<double>& picked() const { return m_picked; }

protected:
    void mouseMoveEvent(QMouseEvent* event) override {
        QChartView::mouseMoveEvent(event);
        pick(nearest(event->position()), true);
    }
    void mousePressEvent(QMouseEvent* event) override {
        m_owner.setFocus(Qt::MouseFocusReason);
        const auto x = nearest(event->position());
        if (event->button() != Qt::LeftButton || !x) return;
        pick(x, true);
        Q_EMIT m_owner.clicked(*x);
    }
    void resizeEvent(QResizeEvent* event) override {
        QChartView::resizeEvent(event);
        showTitles();
    }
    void leaveEvent(QEvent* event) override {
        QChartView::leaveEvent(event);
        pick(std::nullopt, true);
    }
    void drawForeground(QPainter* painter, const QRectF& area) override {
        QChartView::drawForeground(painter, area);
        for (const Curve& curve : m_curves) drawDots(*painter, curve);
        if (m_owner.hasFocus()) drawFocus(*painter);
        if (m_picked && !m_curves.empty()) drawCrosshair(*painter);
    }

private:
    struct Curve {
        QLineSeries* line;
        std::size_t series;
    };

    void addCurve(const metrics::Series& series, const QColor& curveColor, QAbstractAxis* x,
                  QAbstractAxis* y) {
        if (series.points.empty()) return;
        auto* line = new QLineSeries;
        auto* upper = new QLineSeries;
        auto* lower = new QLineSeries;
        for (const metrics::ChartPoint& point : series.points) {
            line->append(point.x, point.y);
            upper->append(point.x, point.y + point.error);
            lower->append(point.x, std::max(point.y - point.error, m_shown.y.least.value_or(0)));
        }
        auto* band = new QAreaSeries(upper, lower);
        upper->setParent(band);
        lower->setParent(band);
        QColor faint = curveColor;
        faint.setAlpha(48);
        band->setBrush(faint);
        band->setPen(Qt::NoPen);
        line->setPen(QPen(curveColor, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const std::array<QAbstractSeries*, 2> both{band, line};
        for (QAbstractSeries* one : both) {
            chart()->addSeries(one);
            one->attachAxis(x);
            one->attachAxis(y);
        }
        m_curves.push_back({line, std::size_t(&series - m_shown.series.data())});
    }

    const metrics::ChartPoint* pointAt(const metrics::Series& series) const {
        const auto found = std::ranges::find(series.points, *m_picked, &metrics::ChartPoint::x);
        return found == series.points.end() ? nullptr : &*found;
    }
    std::optional<double> nearest(QPointF position) const {
        if (m_curves.empty() || !chart()->plotArea().adjusted(-8, -40, 8, 40).contains(position))
            return std::nullopt;
        const auto distance = [&](double x) {
            return std::abs(chart()->mapToPosition({x, 0}, m_curves.front().line).x() - position.x());
        };
        return *std::ranges::min_element(m_xs, {}, distance);
    }

    /// Where a curve was measured.
    void drawDots(QPainter& painter, const Curve& curve) const {
        painter.setPen(Qt::NoPen);
        painter.setBrush(color(curve.series));
        for (const metrics::ChartPoint& point : m_shown.series[curve.series].points)
            painter.drawEllipse(chart()->mapToPosition({point.x, point.y}, curve.line), dotRadius, dotRadius);
    }
    void drawFocus(QPainter& painter) const {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(m_owner.palette().color(QPalette::Highlight).darker(150), 1));
        painter.drawRect(sceneRect().adjusted(0.5, 0.5, -0.5, -0.5));
    }
    void drawCrosshair(QPainter& painter) const {
        const QRectF plot = chart()->plotArea();
        const double x = chart()->mapToPosition({*m_picked, 0}, m_curves.front().line).x();
        painter.setPen(QPen(m_owner.palette().color(QPalette::PlaceholderText), 1, Qt::DashLine));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        for (const Curve& curve : m_curves) {
            const auto* point = pointAt(m_shown.series[curve.series]);
            if (!point) continue;
            painter.setPen(QPen(m_owner.palette().color(QPalette::Base), 1.5));
            painter.setBrush(color(curve.series));
            painter.drawEllipse(chart()->mapToPosition({point->x, point->y}, curve.line), 4.5, 4.5);
        }
        drawNote(painter, x);
    }
    /// A line of the note: the curve it is of, and what it says, with the curve's name or where there is no
    /// room for that without.
    struct NoteLine {
        std::size_t series;
        QString full, brief;
    };
    std::vector<NoteLine> noteLines() const {
        std::vector<NoteLine> lines;
        for (std::size_t i = 0; i < m_shown.series.size(); ++i)
            if (const auto* point = pointAt(m_shown.series[i]))
                lines.push_back({i, lineOf(m_shown.series[i], *point), QString::number(point->y, 'f', 4)});
        return lines;
    }
    /// Beside the crosshair, at the side where there is room, and above or below where the curves aren't.
    void drawNote(QPainter& painter, double x) const {
        const std::vector<NoteLine> lines = noteLines();
        painter.setFont(m_owner.font());
        const QFontMetricsF metrics(m_owner.font());
        const auto widthOf = [&](QString NoteLine::*text) {
            double width = metrics.horizontalAdvance(heading());
            for (const NoteLine& line : lines)
                width = std::max(width, metrics.horizontalAdvance(line.*text) + 14);
            return width + 2 * notePadding;
        };
        const bool isBrief = widthOf(&NoteLine::full) > sceneRect().width() * noteShare;
        const auto text = isBrief ? &NoteLine::brief : &NoteLine::full;
        const double width = widthOf(text);
        const double height = metrics.lineSpacing() * double(lines.size() + 1) + 2 * notePadding;
        const bool fitsRight = x + noteGap + width < sceneRect().right();
        const double left = std::clamp(fitsRight ? x + noteGap : x - noteGap - width, sceneRect().left(),
                                       std::max(sceneRect().right() - width, sceneRect().left()));
        const QRectF plot = chart()->plotArea();
        const QRectF box(left, isHigh() ? plot.bottom() - height - 4 : plot.top(), width, height);
        painter.setPen(QPen(m_owner.palette().color(QPalette::Light), 1));
        painter.setBrush(m_owner.palette().color(QPalette::ToolTipBase));
        painter.drawRoundedRect(box, 3, 3);
        QRectF line(box.left() + notePadding, box.top() + notePadding, width, metrics.lineSpacing());
        painter.setPen(m_owner.palette().color(QPalette::PlaceholderText));
        painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, heading());
        for (const NoteLine& one : lines) {
            line.translate(0, metrics.lineSpacing());
            painter.setPen(Qt::NoPen);
            painter.setBrush(color(one.series));
            painter.drawEllipse(QPointF(line.left() + 4, line.center().y()), 3.5, 3.5);
            painter.setPen(m_owner.palette().color(QPalette::ToolTipText));
            painter.drawText(line.translated(14, 0), Qt::AlignLeft | Qt::AlignVCenter, one.*text);
        }
    }
    /// Whether what is picked lies in the upper half of the chart.
    bool isHigh() const {
        double sum = 0;
        int count = 0;
        for (const Curve& curve : m_curves)
            if (const auto* point = pointAt(m_shown.series[curve.series])) {
                sum += chart()->mapToPosition({point->x, point->y}, curve.line).y();
                ++count;
            }
        return count > 0 && sum / count < chart()->plotArea().center().y();
    }

    MetricGraph& m_owner;
    metrics::LineChart m_shown;
    std::optional<double> m_picked;
    QString m_kind;
    QString m_unit;
    double m_most = 0;
    std::vector<double> m_xs;  ///< where any curve has a point, rising
    std::vector<Curve> m_curves;
};

MetricGraph::MetricGraph(QWidget* parent) : QWidget(parent), m_view(new View(*this)) {
    setFocusPolicy(Qt::StrongFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view);
    setChart({});
}

MetricGraph::~MetricGraph() = default;

void MetricGraph::setChart(const metrics::LineChart& chart, const QString& kind, const QString& unit) {
    setAccessibleName(coreText(chart.title));
    m_view->show(chart, kind, unit);
}

const metrics::LineChart& MetricGraph::chart() const {
    return m_view->shown();
}

void MetricGraph::setMost(double y) {
    m_view->setMost(y);
}

void MetricGraph::pick(std::optional<double> x) {
    m_view->pick(x, false);
}

std::optional<double> MetricGraph::picked() const {
    return m_view->picked();
}

QString MetricGraph::note() const {
    return m_view->note();
}

QColor MetricGraph::color(std::size_t series) {
    return QColor::fromRgb(curveColors[series % curveColors.size()]);
}

void MetricGraph::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Left) return m_view->step(-1);
    if (event->key() == Qt::Key_Right) return m_view->step(1);
    const bool takes = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (takes && picked()) {
        Q_EMIT clicked(*picked());
        return;
    }
    QWidget::keyPressEvent(event);
}

void MetricGraph::focusOutEvent(QFocusEvent* event) {
    m_view->pick(std::nullopt, true);
    QWidget::focusOutEvent(event);
}

void MetricGraph::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) m_view->applyPalette();
    QWidget::changeEvent(event);
}

}  // namespace chiaro::widgets
