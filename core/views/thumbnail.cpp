#include "core/views/thumbnail.h"

#include "core/views/group_map.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace chiaro::views {

namespace {

/// What a sample shows.
struct Shown {
    std::uint32_t face;
    bool painted;
    bool behind;  ///< the group lies behind other faces
};

glm::vec3 colorOf(const Shown& shown, const Surface& surface, const Projector& projector,
                  const ThumbnailStyle& style) {
    if (shown.face == noFace) return style.background;
    const double facing =
        std::abs(projector.facing(surface.centroid(shown.face), surface.normal(shown.face)));
    const float light = 0.35f + 0.65f * float(facing);
    if (shown.painted) return style.painted * light;
    return shown.behind ? style.receding * (0.8f + 0.2f * light) : style.plain * light;
}

}  // namespace

ColorImage drawThumbnail(const Surface& surface, const FaceGroup& group, const ThumbnailStyle& style) {
    View view = group.view;
    view.size = style.side * style.samplesPerPixel;
    const Projector projector(view);
    FaceMask inGroup(surface.faceCount());
    for (const std::uint32_t face : group.faces) inGroup[face] = 1;
    const FaceMap all = drawFaces(surface, view, FaceMask(surface.faceCount(), 1));
    const FaceMap painted = drawFaces(surface, view, inGroup);
    const bool behind = group.pass > 1;
    const auto coincident = float(1e-5 * surface.radius());
    ColorImage picture(style.side, style.side, glm::vec3(0));
    for (int y = 0; y < view.size; ++y)
        for (int x = 0; x < view.size; ++x) {
            // Of two faces that coincide, the painted one is the one to see.
            const bool onTop = painted.depth(x, y) <= all.depth(x, y) + coincident;
            const bool isPainted = painted.face(x, y) != noFace && (behind || onTop);
            const Shown shown{isPainted ? painted.face(x, y) : all.face(x, y), isPainted, behind};
            picture(x / style.samplesPerPixel, y / style.samplesPerPixel) +=
                colorOf(shown, surface, projector, style);
        }
    for (glm::vec3& pixel : picture.pixels()) pixel /= float(style.samplesPerPixel * style.samplesPerPixel);
    return picture;
}

std::vector<ColorImage> drawThumbnails(const Surface& surface, const ViewPlan& plan,
                                       const ThumbnailStyle& style, const Task& task) {
    std::vector<ColorImage> pictures(plan.groups.size());
    Task::Steps steps(task, pictures.size());
    tbb::parallel_for(std::size_t(0), pictures.size(), [&](std::size_t i) {
        task.checkpoint();
        pictures[i] = drawThumbnail(surface, plan.groups[i], style);
        steps.done();
    });
    return pictures;
}

}  // namespace chiaro::views
