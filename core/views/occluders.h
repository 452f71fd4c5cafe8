#pragma once

#include "core/views/surface.h"

#include <memory>
#include <vector>

namespace chiaro::views {

/// One value a face; not 0 for those that take part.
using FaceMask = std::vector<std::uint8_t>;

/// The faces of a surface that are drawn and so may hide others, ready for rays (Embree). Immutable once
/// built; casts from any thread. The surface must outlive it.
class Occluders {
public:
    /// Which of the drawn faces hide what lies behind them.
    enum class Sides {
        Both,
        Fronts  ///< only those that face the eye with n.v > minimumFacing
    };

    /// `drawn` is not 0 for the faces to take; faces without area are left out. Throws Error when there is
    /// not enough memory.
    Occluders(const Surface& surface, FaceMask drawn, Sides sides, double minimumFacing);
    ~Occluders();
    Occluders(Occluders&&) noexcept;

    const Surface& surface() const { return m_surface; }
    /// Whether a face may hide others from a view that it faces with this n.v.
    bool hides(std::uint32_t face, double facing) const {
        return m_drawn[face] != 0 && (m_sides == Sides::Both || facing > m_minimumFacing);
    }
    /// How much nearer, along a ray, a face must be to hide one with this n.v: coincident faces are not.
    double slack(double facing) const { return m_surface.coincidence() / facing; }

    /// Whether a drawn face that is not adjacent to `face` lies between a point of `face` and the eye, which
    /// is `distance` (infinite for an orthographic view) away in the direction `towardsEye` (unit). `facing`
    /// is the face's n.v there, above 0.
    bool hidden(std::uint32_t face, const glm::dvec3& point, const glm::dvec3& towardsEye, double facing,
                double distance) const;
    /// The same for the whole of a face, looked at from its centroid and from near its corners; `distance`
    /// is infinite.
    bool hidden(std::uint32_t face, const glm::dvec3& towardsEye, double facing) const;

    struct Impl;

private:
    const Surface& m_surface;
    FaceMask m_drawn;
    Sides m_sides;
    double m_minimumFacing;
    std::unique_ptr<Impl> m_impl;
};

/// Points by which a face is looked at where texels are too coarse: its centroid, then near its corners.
inline constexpr int probeCount = 4;
glm::dvec3 probeOf(const Surface& surface, std::uint32_t face, int probe);

}  // namespace chiaro::views
