#include "core/views/candidates.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <utility>

namespace chiaro::views {

namespace {

constexpr int spread = 320;  // directions over the sphere, 6 degrees from the nearest at most
constexpr std::size_t sampleLimit = 3000;
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
                                 double minimumFacing, std::vector<glm::dvec3> directions, const Task& task)
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
    m_seen.resize(m_directions.size() * m_samples.size());
    Task::Steps steps(task, m_directions.size());
    tbb::parallel_for(std::size_t(0), m_directions.size(), [&](std::size_t i) {
        for (std::size_t s = 0; s < m_samples.size(); ++s)
            m_seen[i * m_samples.size() + s] = seenAt(m_samples[s], m_directions[i]);
        steps.done();
    });
}

float CandidateScores::seenAt(const Sample& sample, const glm::dvec3& direction) const {
    const double facing = glm::dot(m_surface.normal(sample.face), direction);
    if (!(facing > m_minimumFacing)) return 0;
    if (m_drawn != nullptr && m_drawn->hidden(sample.face, direction, facing)) return 0;
    return float(facing);
}

int CandidateScores::best(double threshold) const {
    int best = -1;
    double highest = 0;
    for (std::size_t i = 0; i < m_directions.size(); ++i) {
        if (m_dropped[i]) continue;
        const std::span<const float> seen = rowOf(i);
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
    for (Sample& sample : m_samples) {
        const float seen = seenAt(sample, direction);
        sample.unseen *= 1 - shown * seen;
        sample.best = std::max(sample.best, seen);
    }
}

void CandidateScores::settle(const FaceMask& covered) {
    for (Sample& sample : m_samples)
        if (covered[sample.face] != 0) sample = {sample.face, sample.weight, 0, 1};
}

}  // namespace chiaro::views
