#include "core/views/group_map.h"

#include "core/views/scan_conversion.h"

namespace chiaro::views {

FaceMap drawFaces(const Surface& surface, const View& view, const FaceMask& drawn) {
    const ProjectedMesh projected(surface, view);
    FaceMap map{Image<std::uint32_t>(view.size, view.size, noFace),
                ScalarImage(view.size, view.size, std::numeric_limits<float>::infinity())};
    Image<double> depths(view.size, view.size, std::numeric_limits<double>::infinity());
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face) {
        if (drawn[face] == 0) continue;
        const std::optional<FaceScan> scan = FaceScan::of(projected, face);
        if (!scan) continue;
        scan->scan(projected.boxOf(face), [&](int x, int y, double depth) {
            if (!(depth < depths(x, y))) return;
            depths(x, y) = depth;
            map.face(x, y) = face;
            map.depth(x, y) = float(depth);
        });
    }
    return map;
}

FaceMap drawGroup(const Surface& surface, const FaceGroup& group) {
    FaceMask drawn(surface.faceCount());
    for (const std::uint32_t face : group.faces) drawn[face] = 1;
    return drawFaces(surface, group.view, drawn);
}

}  // namespace chiaro::views
