#pragma once

#include "core/base/task.h"
#include "core/views/occluders.h"
#include "core/views/view.h"

#include <vector>

namespace chiaro::views {

/// What a visibility query asks for.
struct VisibilityQuery {
    double minimumFacing = 0.05;       ///< faces with n.v at most this are not asked for
    const FaceMask* wanted = nullptr;  ///< not 0 for faces that are asked for; null for all
};

/// The faces that belong to a view (§4.3.2), ascending: they face it, and at no texel centre that they cover
/// does a drawn, non-adjacent face lie nearer by more than rounding; so coincident faces do not hide each
/// other. A face so small or thin that it covers no texel centre is looked at along rays from its centroid
/// and from near its corners instead. Zero-area faces neither hide nor are found. Deterministic for any
/// number of threads. Throws Cancelled.
std::vector<std::uint32_t> visibleFaces(const Occluders& drawn, const View& view,
                                        const VisibilityQuery& query, const Task& task = {});

}  // namespace chiaro::views
