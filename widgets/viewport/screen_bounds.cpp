#include "widgets/viewport/screen_bounds.h"

namespace chiaro::widgets {

QRect screenBounds(const scene::Bounds& bounds, const glm::mat4& objectToClip, QSize pixels) {
    const QRect whole(QPoint(0, 0), pixels);
    glm::vec2 lowest(std::numeric_limits<float>::infinity());
    glm::vec2 highest = -lowest;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point((corner & 1) ? bounds.maximum.x : bounds.minimum.x,
                              (corner & 2) ? bounds.maximum.y : bounds.minimum.y,
                              (corner & 4) ? bounds.maximum.z : bounds.minimum.z);
        const glm::vec4 clip = objectToClip * glm::vec4(point, 1);
        if (!(clip.w > 0)) return whole;
        const glm::vec2 at =
            (glm::vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * glm::vec2(pixels.width(), pixels.height());
        lowest = glm::min(lowest, at);
        highest = glm::max(highest, at);
    }
    // A pixel around, for rounding; clamped before it becomes an integer.
    const glm::vec2 size(pixels.width(), pixels.height());
    const glm::ivec2 first(glm::clamp(glm::floor(lowest) - 1.0f, glm::vec2(0), size));
    const glm::ivec2 end(glm::clamp(glm::ceil(highest) + 1.0f, glm::vec2(0), size));
    return QRect(first.x, first.y, end.x - first.x, end.y - first.y);
}

}  // namespace chiaro::widgets
