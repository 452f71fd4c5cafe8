#include "widgets/viewport/heat_overlay.h"

#include "core/metrics/heat_map.h"
#include "widgets/picture.h"
#include "widgets/round_step.h"

#include <QtWidgets>

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr double margin = 12;
constexpr double padding = 10;
constexpr double barWidth = 190;
constexpr double barHeight = 10;
constexpr int tickCount = 4;
constexpr double stripWidth = 200;
constexpr double largestStripHeight = 70;
constexpr int mapAlpha = 225;  ///< the form below still shows

const QColor ground(0x18, 0x18, 0x18, 225);
const QColor edge(0x4c, 0x4c, 0x4c);
const QColor bright(0xe4, 0xe4, 0xe4);
const QColor dim(0xa4, 0xa4, 0xa4);

/// The colours from dark to bright, a pixel high.
const QImage& colorBar() {
    static const QImage bar = [] {
        ScalarImage values(256, 1);
        for (int x = 0; x < 256; ++x) values(x, 0) = float(x) / 255;
        return toImage(metrics::heatMap(values, 0, 1));
    }();
    return bar;
}

void drawBox(QPainter& painter, const QRectF& box) {
    painter.setPen(QPen(edge, 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

}  // namespace

void HeatMap::paint() {
    const ColorImage colors = metrics::heatMap(values, 0, most);
    picture = QImage(values.width(), values.height(), QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < values.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < values.width(); ++x) {
            const glm::ivec3 color(colors(x, y) * 255.0F + 0.5F);
            line[x] = values(x, y) >= 0 ? qPremultiply(qRgba(color.r, color.g, color.b, mapAlpha)) : 0;
        }
    }
}

HeatOverlay::HeatOverlay(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Heat map"));
}

void HeatOverlay::setMaps(std::vector<std::shared_ptr<const HeatMap>> maps) {
    if (maps == m_maps) return;
    m_maps = std::move(maps);
    setAccessibleDescription(map() ? tr("%1, 0 to %2").arg(map()->title).arg(double(map()->most))
                                   : QString());
    update();
}

void HeatOverlay::setPanes(std::vector<Pane> panes) {
    m_panes = std::move(panes);
    update();
}

std::vector<Pane> HeatOverlay::panes() const {
    return m_panes.empty() ? std::vector{Pane{rect(), QPolygonF(QRectF(rect()))}} : m_panes;
}

std::optional<std::size_t> HeatOverlay::mapAt(QPointF position) const {
    const std::vector<Pane> all = panes();
    for (std::size_t pane = 0; pane < std::min(all.size(), m_maps.size()); ++pane)
        if (all[pane].seen.containsPoint(position, Qt::OddEvenFill)) return pane;
    return std::nullopt;
}

void HeatOverlay::setProgress(const QString& text, std::optional<double> progress) {
    // Repainting what lies over OpenGL composes the whole window: not for a step that nobody sees.
    const bool isStep = m_text == text && m_progress && progress;
    if (isStep && std::abs(*progress - *m_progress) < 0.01) return;
    m_text = text;
    m_progress = progress;
    update();
}

std::optional<HeatOverlay::Reading> HeatOverlay::reading(QPointF position) const {
    const auto pane = mapAt(position);
    if (!pane || !m_maps[*pane]) return std::nullopt;
    const HeatMap& map = *m_maps[*pane];
    const QRectF rect = panes()[*pane].rect;
    const QPointF at = position - rect.topLeft();
    const glm::ivec2 pixel(int(std::floor(at.x() * map.values.width() / std::max(rect.width(), 1.0))),
                           int(std::floor(at.y() * map.values.height() / std::max(rect.height(), 1.0))));
    if (!map.values.contains(pixel.x, pixel.y)) return std::nullopt;
    const float value = map.values(pixel.x, pixel.y);
    if (!(value >= 0)) return std::nullopt;
    return Reading{value, map.objects(pixel.x, pixel.y), glm::ivec2(map.best(pixel.x, pixel.y)), *pane};
}

void HeatOverlay::mouseMoveEvent(QMouseEvent* event) {
    m_pointer = event->position();
    if (map()) update();
    event->ignore();
}

void HeatOverlay::leaveEvent(QEvent*) {
    m_pointer.reset();
    update();
}

void HeatOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const std::vector<Pane> all = panes();
    for (std::size_t pane = 0; map() && pane < std::min(all.size(), m_maps.size()); ++pane) {
        QPainterPath seen;
        seen.addPolygon(all[pane].seen);
        painter.setClipPath(seen);
        painter.drawImage(all[pane].rect, m_maps[pane]->picture);
    }
    painter.setClipping(false);
    if (map() || m_progress) drawPanel(painter);
    const auto read = m_pointer ? reading(*m_pointer) : std::nullopt;
    if (read) drawReading(painter, *read);
}

QRectF HeatOverlay::panel() const {
    const double line = fontMetrics().lineSpacing();
    const double height = 2 * padding + line + (map() ? 6 + barHeight + 4 + line : 10);
    const double boxWidth = std::min(barWidth + 2 * padding + 16, width() - 2 * margin);
    return {width() - margin - boxWidth, this->height() - margin - height, boxWidth, height};
}

/// The bar of colours, and what is going on, in the corner where no paint is looked at.
void HeatOverlay::drawPanel(QPainter& painter) const {
    const QRectF box = panel();
    drawBox(painter, box);
    const double line = fontMetrics().lineSpacing();
    const QRectF inner = box.adjusted(padding + 8, padding, -padding - 8, -padding);
    const QRectF head(inner.left(), inner.top(), inner.width(), line);
    painter.setPen(bright);
    if (map()) painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, map()->title);
    if (m_progress) {
        painter.setPen(dim);
        const Qt::AlignmentFlag side = map() ? Qt::AlignRight : Qt::AlignLeft;
        painter.drawText(head, side | Qt::AlignVCenter, m_text);
        const QRectF track(inner.left(), head.bottom() + 3, inner.width(), 2);
        painter.fillRect(track, edge);
        QRectF done = track;
        done.setWidth(track.width() * std::clamp(*m_progress, 0.0, 1.0));
        painter.fillRect(done, palette().color(QPalette::Highlight));
    }
    if (map()) drawBar(painter, {inner.left(), head.bottom() + 8, inner.width(), barHeight});
}

void HeatOverlay::drawBar(QPainter& painter, const QRectF& bar) const {
    painter.drawImage(bar, colorBar());
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(edge, 1));
    painter.drawRect(bar);
    const double most = double(map()->most), step = roundStep(most, tickCount);
    for (int tick = 0; tick * step <= most * (1 + 1e-6); ++tick) {
        const double x = bar.left() + tick * step / most * bar.width();
        painter.setPen(QPen(dim, 1));
        painter.drawLine(QPointF(x, bar.bottom() + 1), QPointF(x, bar.bottom() + 4));
        painter.drawText(QRectF(x - 30, bar.bottom() + 4, 60, fontMetrics().lineSpacing()), Qt::AlignCenter,
                         QString::number(tick * step, 'g', 3));
    }
    const auto read = m_pointer ? reading(*m_pointer) : std::nullopt;
    if (!read) return;
    const double x =
        bar.left() + bar.width() * std::clamp(double(read->value) / double(map()->most), 0.0, 1.0);
    painter.setPen(QPen(QColor(0, 0, 0), 3));
    painter.drawLine(QPointF(x, bar.top() - 1), QPointF(x, bar.bottom() + 1));
    painter.setPen(QPen(QColor(Qt::white), 1.4));
    painter.drawLine(QPointF(x, bar.top() - 1), QPointF(x, bar.bottom() + 1));
}

/// The value under the pointer, and its best match marked in the strip.
void HeatOverlay::drawReading(QPainter& painter, const Reading& reading) const {
    const std::size_t object = reading.object;
    const std::vector<HeatStrip>& strips = m_maps[reading.pane]->strips;
    const bool hasStrip =
        object > 0 && object <= strips.size() && !strips[object - 1].picture.isNull() && reading.best.x >= 0;
    const HeatStrip strip = hasStrip ? strips[object - 1] : HeatStrip{};
    const double line = fontMetrics().lineSpacing();
    const double stripHeight =
        hasStrip ? std::clamp(stripWidth * strip.size.height() / strip.size.width(), 16.0, largestStripHeight)
                 : 0;
    const QSizeF size(hasStrip ? stripWidth + 2 * padding : 110,
                      2 * padding + line + (hasStrip ? 6 + stripHeight : 0));
    QPointF at = *m_pointer + QPointF(16, 16);
    if (at.x() + size.width() > width() - margin) at.setX(m_pointer->x() - 16 - size.width());
    if (at.y() + size.height() > height() - margin) at.setY(m_pointer->y() - 16 - size.height());
    if (QRectF(at, size).intersects(panel())) at.setY(panel().top() - 6 - size.height());
    const QRectF box(at, size);
    drawBox(painter, box);
    const QRectF head(box.left() + padding, box.top() + padding, box.width() - 2 * padding, line);
    painter.setPen(bright);
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, QString::number(double(reading.value), 'f', 4));
    if (!hasStrip) return;
    painter.setPen(dim);
    painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, tr("best match in the strip"));
    const QRectF shown(head.left(), head.bottom() + 6, stripWidth, stripHeight);
    painter.drawImage(shown, strip.picture);
    const QPointF mark(shown.left() + (reading.best.x + 0.5) / strip.size.width() * shown.width(),
                       shown.top() + (reading.best.y + 0.5) / strip.size.height() * shown.height());
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 190), 3.4));
    painter.drawEllipse(mark, 5, 5);
    painter.setPen(QPen(QColor(Qt::white), 1.5));
    painter.drawEllipse(mark, 5, 5);
}

}  // namespace chiaro::widgets
