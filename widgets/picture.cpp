#include "widgets/picture.h"

#include <algorithm>

namespace chiaro::widgets {

namespace {

int toByte(float value) {
    return int(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F);
}

QRgb toRgb(glm::vec3 color) {
    return qRgb(toByte(color.r), toByte(color.g), toByte(color.b));
}

}  // namespace

QColor toColor(glm::vec3 color) {
    return QColor::fromRgb(toRgb(color));
}

glm::vec3 fromColor(const QColor& color) {
    return {float(color.redF()), float(color.greenF()), float(color.blueF())};
}

QImage toImage(const ColorImage& image, float offset) {
    QImage result(image.width(), image.height(), QImage::Format_RGB32);
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(result.scanLine(y));
        for (const glm::vec3& pixel : image.row(y)) *line++ = toRgb(pixel + offset);
    }
    return result;
}

QImage toImage(const gradient::Gradient& gradient) {
    QImage result(int(gradient.size()), 1, QImage::Format_RGB32);
    std::transform(gradient.begin(), gradient.end(), reinterpret_cast<QRgb*>(result.bits()), toRgb);
    return result;
}

ColorImage reduced(const ColorImage& image, int maximumWidth, int maximumHeight) {
    const int factorX = (image.width() + maximumWidth - 1) / maximumWidth;
    const int factorY = (image.height() + maximumHeight - 1) / maximumHeight;
    if (factorX <= 1 && factorY <= 1) return image;
    ColorImage result(std::max(1, image.width() / factorX), std::max(1, image.height() / factorY));
    const int stepX = std::min(factorX, image.width());
    const int stepY = std::min(factorY, image.height());
    for (int y = 0; y < result.height(); ++y)
        for (int x = 0; x < result.width(); ++x) {
            glm::vec3 sum(0);
            for (int dy = 0; dy < stepY; ++dy)
                for (int dx = 0; dx < stepX; ++dx) sum += image(x * stepX + dx, y * stepY + dy);
            result(x, y) = sum / float(stepX * stepY);
        }
    return result;
}

}  // namespace chiaro::widgets
