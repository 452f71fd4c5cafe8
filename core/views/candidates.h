#pragma once

#include "core/base/task.h"
#include "core/views/occluders.h"

#include <vector>

namespace chiaro::views {

/// Directions worth looking from: the six axes, then points spread evenly over the sphere (Fibonacci).
std::vector<glm::dvec3> candidateDirections();

/// How many faces stand for the whole of a surface, and for what further passes are about.
inline constexpr std::size_t samplesOfAll = 3000;
inline constexpr std::size_t samplesOfRest = 1000;

/// Faces that stand for a part of a surface, and how well each of some directions sees them. Small parts are
/// looked at face by face; of large ones as many faces are taken as asked for, spread evenly over the area.
class CandidateScores {
public:
    /// Samples the faces whose `part` is not 0, hidden by `drawn` (null: by nothing) and seen with n.v above
    /// minimumFacing. Throws Cancelled.
    CandidateScores(const Surface& surface, const FaceMask& part, const Occluders* drawn,
                    double minimumFacing, std::size_t sampleLimit, std::vector<glm::dvec3> directions,
                    const Task& task);

    const std::vector<glm::dvec3>& directions() const { return m_directions; }
    /// The direction that promises most: area times n.v, each face counting less the better the views taken
    /// so far show it. -1 when none would improve on them by more than `threshold` of the part's area.
    int best(double threshold) const;
    /// A view is taken from here: the faces it shows count less from now on.
    void take(const glm::dvec3& direction);
    /// This direction turned out to show nothing.
    void drop(int index) { m_dropped[std::size_t(index)] = true; }
    /// These faces (`covered` not 0) need no further view.
    void settle(const FaceMask& covered);

private:
    /// A face that stands for `weight` of the part's area.
    struct Sample {
        std::uint32_t face;
        float weight;
        float unseen = 1;  ///< how much it still counts
        float best = 0;    ///< n.v of the view that shows it best so far
    };
    /// n.v of each sample from a direction, 0 where hidden.
    std::vector<float> seenFrom(const glm::dvec3& direction) const;

    const Surface& m_surface;
    const Occluders* m_drawn;
    double m_minimumFacing;
    std::vector<glm::dvec3> m_directions;
    std::vector<bool> m_dropped;
    std::vector<Sample> m_samples;
    std::vector<std::vector<float>> m_seen;  ///< from each direction
};

}  // namespace chiaro::views
