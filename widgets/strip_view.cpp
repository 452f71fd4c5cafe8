#include "widgets/strip_view.h"

#include "widgets/picture.h"

#include <QtWidgets>

namespace chiaro::widgets {

namespace {

enum { StripRow, AveragesRow, GradientRow, TextureRow, RecoloredRow };

constexpr int pictureHeight = 44;
constexpr int barHeight = 14;
constexpr int gap = 7;

}  // namespace

StripPictures StripPictures::of(const ColorImage& strip, const gradient::Separation& separation) {
    return {reduced(strip, 1024, 192), reduced(separation.texture, 1024, 192), separation.averages,
            separation.gradient};
}

StripView::StripView(QWidget* parent) : QWidget(parent) {
    m_rows = {Row{tr("Strip"), tr("The strip, dark to light"), {}, pictureHeight},
              Row{tr("Averages"), tr("The mean colour of each column"), {}, barHeight},
              Row{tr("Gradient"), tr("The sorted colours at the speed of the curve, G(u(x))"), {}, barHeight},
              Row{tr("Texture"), tr("The strip without its gradient, on middle grey"), {}, pictureHeight},
              Row{tr("Recoloured"), tr("The texture over the gradient in use"), {}, pictureHeight}};
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Strip, averages, gradient and texture"));
}

void StripView::setPictures(std::shared_ptr<const StripPictures> pictures) {
    if (m_pictures == pictures) return;
    m_pictures = std::move(pictures);
    if (m_pictures) {
        m_rows[StripRow].picture = toImage(m_pictures->strip);
        m_rows[AveragesRow].picture = toImage(m_pictures->averages);
        m_rows[GradientRow].picture = toImage(m_pictures->gradient);
        m_rows[TextureRow].picture = toImage(m_pictures->texture, 0.5F);
    } else {
        for (Row& row : m_rows) row.picture = {};
    }
    m_rows[RecoloredRow].picture = {};
    update();
}

void StripView::setRecoloring(const gradient::Gradient& gradient) {
    if (!m_pictures) return;
    const gradient::Gradient& used = gradient.empty() ? m_pictures->gradient : gradient;
    const int columns = m_pictures->texture.width();
    m_rows[RecoloredRow].picture =
        toImage(gradient::recolored(m_pictures->texture, gradient::resample(used, columns)));
    update();
}

QSize StripView::sizeHint() const {
    int height = 0;
    for (int row = 0; row < int(m_rows.size()); ++row) height += rowHeight(row) + (row > 0 ? gap : 0);
    return {280, height};
}

int StripView::rowHeight(int row) const {
    return m_rows[std::size_t(row)].height;
}

std::optional<glm::vec3> StripView::colorAt(QPointF position) const {
    int top = 0;
    for (const Row& row : m_rows) {
        const QRectF area = pictureArea(row, top);
        top += row.height + gap;
        if (!area.contains(position) || row.picture.isNull()) continue;
        const auto pixel = [](double place, double length, int count) {
            return std::clamp(int(place / length * count), 0, count - 1);
        };
        return fromColor(
            row.picture.pixelColor(pixel(position.x() - area.left(), area.width(), row.picture.width()),
                                   pixel(position.y() - area.top(), area.height(), row.picture.height())));
    }
    return std::nullopt;
}

QRect StripView::pictureArea(const Row& row, int top) const {
    const int captionWidth = fontMetrics().horizontalAdvance(m_rows[RecoloredRow].caption) + 12;
    return {captionWidth, top, width() - captionWidth, row.height};
}

bool StripView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        auto* help = static_cast<QHelpEvent*>(event);
        int top = 0;
        for (const Row& row : m_rows) {
            if (help->y() >= top && help->y() < top + row.height) {
                QToolTip::showText(help->globalPos(), row.tooltip, this);
                return true;
            }
            top += row.height + gap;
        }
    }
    return QWidget::event(event);
}

void StripView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    int top = 0;
    for (const Row& row : m_rows) {
        paintRow(painter, row, top);
        top += row.height + gap;
    }
}

void StripView::paintRow(QPainter& painter, const Row& row, int top) const {
    const QRect area = pictureArea(row, top);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(QRect(0, top, area.left(), row.height), Qt::AlignVCenter | Qt::AlignLeft, row.caption);
    if (row.picture.isNull()) {
        painter.fillRect(area, palette().color(QPalette::Base));
        return;
    }
    // Fewer pixels than the picture has are averaged; more are shown as they are, crisp.
    const double ratio = devicePixelRatioF();
    const QSize size = (QSizeF(area.size()) * ratio).toSize();
    const bool shrinks = row.picture.width() > size.width();
    QImage scaled = row.picture.scaled(size.width(), row.picture.height(), Qt::IgnoreAspectRatio,
                                       shrinks ? Qt::SmoothTransformation : Qt::FastTransformation);
    scaled = scaled.scaled(
        size, Qt::IgnoreAspectRatio,
        row.picture.height() > size.height() ? Qt::SmoothTransformation : Qt::FastTransformation);
    painter.drawImage(area, scaled);
}

}  // namespace chiaro::widgets
