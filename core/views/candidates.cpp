#include "core/views/candidates.h"

#include "core/views/visibility.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <utility>

namespace chiaro::views {

namespace {

constexpr int spread = 320;  // directions over the sphere, 6 degrees from the nearest at most
// Faces of small meshes may be large and hidden in part, which a few rays miss: those are drawn coarsely.
constexpr std::size_t exactLimit = 6000;
constexpr int coarseSize = 128;
// What a view with n.v = 1 leaves a face to count: enough to prefer some overlap over none.
constexpr float shown = 0.9f;

}  // namespace

std::vector<glm::dvec3> candidateDirections() {
    std::vector<glm::dvec3> directions{{0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    const double golden = M_PI * (3 - std::sqrt(5.0));
    for (int i = 0; i < spread; ++i) {
        const double y = 1 - (2 * i + 1.0) / spread;
        const double radius = std::sqrt(1 - y * y);
        directions.emplace_back(radius * std::sin(golden * i), y, radius * std::cos(golden * i));
    }
    return directions;
}

CandidateScores::CandidateScores(const Surface& surface, const FaceMask& part, const Occluders* drawn,
                                 double minimumFacing, std::size_t sampleLimit,
                                 std::vector<glm::dvec3> directions, const Task& task)
    : m_surface(surface),
      m_drawn(drawn),
      m_minimumFacing(minimumFacing),
      m_directions(std::move(directions)),
      m_dropped(m_directions.size()) {
    std::size_t count = 0;
    double area = 0;
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face)
        if (part[face] != 0 && surface.area(face) > 0) {
            ++count;
            area += surface.area(face);
        }
    const double step = area / double(sampleLimit);
    double passed = 0;  // of the area, in steps
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face) {
        if (part[face] == 0 || !(surface.area(face) > 0)) continue;
        const double before = passed;
        passed += surface.area(face) / step;
        // Slivers are to be found too when they alone are left.
        const double stands = count <= sampleLimit ? std::max(surface.area(face) / area, 1e-9)
                                                   : (std::floor(passed + 0.5) - std::floor(before + 0.5)) /
                                                         double(sampleLimit);
        if (stands > 0) m_samples.push_back({face, float(stands)});
    }
    m_seen.resize(m_directions.size());
    Task::Steps steps(task, m_directions.size());
    tbb::parallel_for(std::size_t(0), m_directions.size(), [&](std::size_t i) {
        m_seen[i] = seenFrom(m_directions[i]);
        steps.done();
    });
}

std::vector<float> CandidateScores::seenFrom(const glm::dvec3& direction) const {
    std::vector<float> seen(m_samples.size());
    if (m_drawn != nullptr && m_surface.faceCount() <= exactLimit) {
        View view;
        view.direction = direction;
        view.size = coarseSize;
        const std::vector<std::uint32_t> faces =
            visibleFaces(*m_drawn, framed(view, m_surface), {m_minimumFacing, nullptr});
        FaceMask visible(m_surface.faceCount());
        for (const std::uint32_t face : faces) visible[face] = 1;
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (visible[m_samples[i].face] != 0)
                seen[i] = float(glm::dot(m_surface.normal(m_samples[i].face), direction));
        return seen;
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const std::uint32_t face = m_samples[i].face;
        const double facing = glm::dot(m_surface.normal(face), direction);
        if (!(facing > m_minimumFacing)) continue;
        if (m_drawn != nullptr && m_drawn->hidden(face, direction, facing)) continue;
        seen[i] = float(facing);
    }
    return seen;
}

int CandidateScores::best(double threshold) const {
    int best = -1;
    double highest = 0;
    for (std::size_t i = 0; i < m_directions.size(); ++i) {
        if (m_dropped[i]) continue;
        const std::vector<float>& seen = m_seen[i];
        double promise = 0;
        double improvement = 0;
        for (std::size_t s = 0; s < m_samples.size(); ++s) {
            const Sample& sample = m_samples[s];
            promise += double(sample.weight) * double(sample.unseen * seen[s]);
            improvement += double(sample.weight) * double(std::max(seen[s] - sample.best, 0.0f));
        }
        if (promise > highest && improvement > threshold) {
            highest = promise;
            best = int(i);
        }
    }
    return best;
}

void CandidateScores::take(const glm::dvec3& direction) {
    const std::vector<float> seen = seenFrom(direction);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        m_samples[i].unseen *= 1 - shown * seen[i];
        m_samples[i].best = std::max(m_samples[i].best, seen[i]);
    }
}

void CandidateScores::settle(const FaceMask& covered) {
    for (Sample& sample : m_samples)
        if (covered[sample.face] != 0) sample = {sample.face, sample.weight, 0, 1};
}

}  // namespace chiaro::views
