#pragma once

#include "core/base/parameters.h"
#include "core/base/task.h"
#include "core/views/view.h"

#include <vector>

namespace chiaro::views {

/// How views are planned and which faces they take.
struct ViewParams {
    int count = 12;  ///< views of the first pass, kept ones included, 1..64
    int size = 512;  ///< a map's side, 64..2048 texels
    Projection projection = Projection::Orthographic;
    double epsilon = 0.05;   ///< the smallest n.v of a face in a group, and the smallest alpha, 0.01..0.5
    glm::dvec3 up{0, 1, 0};  ///< the object's own "up", any length but zero; has no spec
    static const ParameterTable<ViewParams>& table();
    friend bool operator==(const ViewParams&, const ViewParams&) = default;
};

/// Which faces were drawn, and so could hide others, when a view's group was made.
enum class Drawn {
    All,              ///< the first pass
    Uncovered,        ///< a further pass: all that no earlier pass covered
    UncoveredFronts,  ///< and of those, where that shows nothing more, only the ones that face the view
    EachAlone  ///< the last resort, for faces that hide each other from everywhere: nothing hides anything
};

/// A view and the faces that belong to it (§4.3.2): those that face it and of which nothing nearer covers a
/// pixel, adjacent faces excepted.
struct FaceGroup {
    View view;
    int pass = 1;  ///< 1.. ; a further pass keeps only faces that no earlier one covered
    Drawn drawn = Drawn::All;
    std::vector<std::uint32_t> faces;  ///< ascending; empty for a kept view that sees nothing
    friend bool operator==(const FaceGroup&, const FaceGroup&) = default;
};

/// The views of one object. Every face with area is in at least one group.
struct ViewPlan {
    std::vector<FaceGroup> groups;           ///< kept views first, in their order; then by pass
    std::vector<std::uint32_t> unreachable;  ///< faces without area, ascending: no view can show them
    int passes = 0;                          ///< 0 when no face has area: there are no planned views then
    friend bool operator==(const ViewPlan&, const ViewPlan&) = default;
};

/// Plans the views of an object (§4.3.1 to 3). The first pass keeps the views of `kept` (framed anew, their
/// maps as large as the parameters say) and adds, from some hundreds of directions, the ones from which most
/// surface is seen at good angles that the views so far do not show as well, until there are `count` or
/// another one would improve nothing. Further passes hide what is covered and go on with the rest until
/// nothing is left; they end for every mesh. Deterministic for any number of threads. Throws Error when a
/// parameter is out of range or a direction has no length, Cancelled when the task was.
ViewPlan planViews(const Surface& surface, const ViewParams& params, const std::vector<View>& kept = {},
                   const Task& task = {});

/// A plan with further views of the faces that it shows at more than 60 degrees only, as happens where other
/// faces stand before them: from there they would be painted with streaks. These passes draw only those
/// faces, which stay in the groups that they are in. What is left is less than a view is worth. Throws
/// Cancelled.
ViewPlan withSteepFacesSeen(const Surface& surface, ViewPlan plan, const ViewParams& params,
                            const Task& task = {});

}  // namespace chiaro::views
