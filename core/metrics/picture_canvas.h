#pragma once

#include "core/base/image.h"
#include "core/metrics/chart_canvas.h"

#include <memory>

namespace chiaro::metrics {

/// Charts as a picture at twice their normal size, with smooth edges. Its letters are plain ones: what isn't
/// ASCII becomes a question mark.
class PictureCanvas : public ChartCanvas {
public:
    explicit PictureCanvas(glm::dvec2 size);
    ~PictureCanvas() override;
    void moveTo(glm::dvec2 origin) override;
    void text(glm::dvec2 place, const std::string& text, Anchor anchor, Lettering lettering) override;
    void line(std::span<const glm::dvec2> points, Stroke stroke, unsigned color) override;
    void dot(glm::dvec2 place, unsigned color, const std::string& words) override;
    /// Display-referred RGB in [0, 1].
    ColorImage picture() const;

private:
    struct Paper;
    std::unique_ptr<Paper> m_paper;
};

}  // namespace chiaro::metrics
