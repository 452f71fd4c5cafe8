#include "widgets/viewport/composition.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiaro::widgets {

namespace {

constexpr double gap = 2;

template <class Channel>
QRgb mapped(QRgb first, QRgb second, Channel channel) {
    return qRgb(channel(qRed(first), qRed(second)), channel(qGreen(first), qGreen(second)),
                channel(qBlue(first), qBlue(second)));
}

/// The least and the largest offset of a line with this normal that meets the picture.
std::pair<double, double> spanAlong(glm::dvec2 normal, QSizeF size) {
    const double x = normal.x * size.width(), y = normal.y * size.height();
    return {std::min(x, 0.0) + std::min(y, 0.0), std::max(x, 0.0) + std::max(y, 0.0)};
}

/// A picture of both; `pixel` gets their pixels, x and y.
template <class Pixel>
QImage combined(const QImage& first, const QImage& second, Pixel pixel) {
    QImage result(first.size(), QImage::Format_RGB32);
    for (int y = 0; y < result.height(); ++y) {
        const auto* a = reinterpret_cast<const QRgb*>(first.constScanLine(y));
        const auto* b = reinterpret_cast<const QRgb*>(second.constScanLine(y));
        auto* line = reinterpret_cast<QRgb*>(result.scanLine(y));
        for (int x = 0; x < result.width(); ++x) line[x] = pixel(a[x], b[x], x, y);
    }
    return result;
}

QImage wiped(const Composition& composition, const QImage& first, const QImage& second) {
    const WipeLine line = wipeLine(composition, first.size());
    return combined(first, second, [&](QRgb a, QRgb b, int x, int y) {
        return line.isSecond({x + 0.5, y + 0.5}) ? b : a;
    });
}

QImage blended(double share, const QImage& first, const QImage& second) {
    const auto channel = [share](int a, int b) { return int(std::lround(a + (b - a) * share)); };
    return combined(first, second, [&](QRgb a, QRgb b, int, int) { return mapped(a, b, channel); });
}

QImage subtracted(double gain, const QImage& first, const QImage& second) {
    const auto channel = [gain](int a, int b) {
        return int(std::lround(std::min(std::abs(a - b) * gain, 255.0)));
    };
    return combined(first, second, [&](QRgb a, QRgb b, int, int) { return mapped(a, b, channel); });
}

}  // namespace

std::size_t Composition::shownCount() const {
    if (mode == Mode::Single || methods.size() < 2) return 1;
    return mode == Mode::SideBySide ? std::min(methods.size(), mostPanes) : 2;
}

WipeLine wipeLine(const Composition& composition, QSizeF size) {
    const double angle = glm::radians(composition.wipeAngle);
    const glm::dvec2 normal(std::cos(angle), std::sin(angle));
    const glm::dvec2 center = composition.wipeCenter * glm::dvec2(size.width(), size.height());
    return {normal, glm::dot(center, normal)};
}

double wipePosition(const Composition& composition, QSizeF size) {
    const WipeLine line = wipeLine(composition, size);
    const auto [least, most] = spanAlong(line.normal, size);
    return std::clamp((line.offset - least) / (most - least), 0.0, 1.0);
}

Composition wipedTo(const Composition& composition, QSizeF size, double position) {
    const glm::dvec2 extent(size.width(), size.height());
    const WipeLine line = wipeLine(composition, size);
    const auto [least, most] = spanAlong(line.normal, size);
    const double offset = least + std::clamp(position, 0.0, 1.0) * (most - least);
    const glm::dvec2 center = composition.wipeCenter * extent + line.normal * (offset - line.offset);
    // Along the line back into the picture.
    const glm::dvec2 along(-line.normal.y, line.normal.x);
    double first = -std::numeric_limits<double>::infinity(), last = -first;
    for (int axis = 0; axis < 2; ++axis) {
        if (std::abs(along[axis]) < 1e-9) continue;
        const double one = -center[axis] / along[axis], other = (extent[axis] - center[axis]) / along[axis];
        first = std::max(first, std::min(one, other));
        last = std::min(last, std::max(one, other));
    }
    const double shift = first <= last ? std::clamp(0.0, first, last) : (first + last) / 2;
    Composition moved = composition;
    moved.wipeCenter = glm::clamp((center + along * shift) / extent, 0.0, 1.0);
    return moved;
}

QPolygonF wipeSide(const Composition& composition, QSizeF size, bool second) {
    const WipeLine line = wipeLine(composition, size);
    const glm::dvec2 normal = second ? line.normal : -line.normal;
    const glm::dvec2 along(-normal.y, normal.x);
    const glm::dvec2 center = composition.wipeCenter * glm::dvec2(size.width(), size.height());
    // Long enough to reach across the picture from any point in it.
    const double reach = 2 * (size.width() + size.height());
    QPolygonF half;
    for (const glm::dvec2 corner : {center + along * reach, center + (along + normal) * reach,
                                    center + (normal - along) * reach, center - along * reach})
        half << QPointF(corner.x, corner.y);
    return half.intersected(QPolygonF(QRectF({}, size)));
}

std::vector<QRect> paneRects(const Composition& composition, QSize size, double ratio) {
    const int count = int(composition.shownCount());
    if (count == 1 || composition.mode != Composition::Mode::SideBySide)
        return std::vector<QRect>(std::size_t(count), QRect({}, size));
    const int between = int(std::lround(gap * ratio));
    const bool isColumn = size.height() > size.width();
    const int length = isColumn ? size.height() : size.width();
    const int side = std::max(1, (length - between * (count - 1)) / count);
    std::vector<QRect> panes;
    for (int pane = 0; pane < count; ++pane) {
        const int from = pane * (side + between);
        panes.push_back(isColumn ? QRect(0, from, size.width(), side) : QRect(from, 0, side, size.height()));
    }
    return panes;
}

std::vector<Pane> panesOf(const Composition& composition, QSize size, double ratio) {
    using Mode = Composition::Mode;
    std::vector<Pane> panes;
    for (const QRect& rect : paneRects(composition, size * ratio, ratio)) {
        const QRectF place(QPointF(rect.topLeft()) / ratio, QSizeF(rect.size()) / ratio);
        panes.push_back({place, QPolygonF(place)});
    }
    if (panes.size() != 2) return panes;
    if (composition.mode == Mode::Wipe)
        for (const bool second : {false, true})
            panes[std::size_t(second)].seen = wipeSide(composition, size, second);
    if (composition.mode == Mode::Blend || composition.mode == Mode::Difference) panes[1].seen.clear();
    return panes;
}

QImage composed(const Composition& composition, std::span<const QImage> pictures, QSize size, double ratio,
                QColor ground) {
    using Mode = Composition::Mode;
    if (composition.shownCount() == 1) return pictures.front();
    switch (composition.mode) {
        case Mode::Wipe:
            return wiped(composition, pictures[0], pictures[1]);
        case Mode::Blend:
            return blended(composition.blend, pictures[0], pictures[1]);
        case Mode::Difference:
            return subtracted(composition.gain, pictures[0], pictures[1]);
        case Mode::Single:
        case Mode::SideBySide:
            break;
    }
    QImage picture(size, QImage::Format_RGB32);
    picture.fill(ground);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);  // a coarse picture is smaller than its pane
    const std::vector<QRect> panes = paneRects(composition, size, ratio);
    for (std::size_t pane = 0; pane < panes.size(); ++pane) painter.drawImage(panes[pane], pictures[pane]);
    return picture;
}

}  // namespace chiaro::widgets
