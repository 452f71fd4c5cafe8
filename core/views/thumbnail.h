#pragma once

#include "core/base/image.h"
#include "core/base/task.h"
#include "core/views/planning.h"

#include <vector>

namespace chiaro::views {

/// How a view's picture looks. Display-referred RGB in [0, 1].
struct ThumbnailStyle {
    int side = 360;           ///< pixels
    int samplesPerPixel = 3;  ///< along each side; smooths edges
    glm::vec3 background{1};
    glm::vec3 painted{0.93f, 0.62f, 0.24f};   ///< faces of the group
    glm::vec3 plain{0.66f, 0.69f, 0.74f};     ///< other faces
    glm::vec3 receding{0.88f, 0.89f, 0.91f};  ///< other faces, where the group lies behind them
};

/// The object as the view of a group sees it, lit from the eye, the group's faces tinted. What a further pass
/// paints lies behind other faces: it shows through them. Thread-safe.
ColorImage drawThumbnail(const Surface& surface, const FaceGroup& group, const ThumbnailStyle& style = {});

/// One a group of the plan, in its order; several at a time. Throws Cancelled.
std::vector<ColorImage> drawThumbnails(const Surface& surface, const ViewPlan& plan,
                                       const ThumbnailStyle& style = {}, const Task& task = {});

}  // namespace chiaro::views
