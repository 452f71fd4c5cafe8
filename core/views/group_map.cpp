#include "core/views/group_map.h"

#include "core/views/scan_conversion.h"

namespace chiaro::views {

Image<std::uint32_t> drawFaces(const Surface& surface, const View& view,
                               const std::vector<std::uint8_t>& drawn) {
    const ProjectedMesh projected(surface, view);
    Image<std::uint32_t> map(view.size, view.size, noFace);
    Image<double> depths(view.size, view.size, std::numeric_limits<double>::infinity());
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face) {
        if (drawn[face] == 0) continue;
        const std::optional<FaceScan> scan = FaceScan::of(projected, face);
        if (!scan) continue;
        scan->scan(projected.boxOf(face), [&](int x, int y, double depth) {
            if (!(depth < depths(x, y))) return;
            depths(x, y) = depth;
            map(x, y) = face;
        });
    }
    return map;
}

Image<std::uint32_t> drawGroup(const Surface& surface, const FaceGroup& group) {
    std::vector<std::uint8_t> drawn(surface.faceCount());
    for (const std::uint32_t face : group.faces) drawn[face] = 1;
    return drawFaces(surface, group.view, drawn);
}

}  // namespace chiaro::views
