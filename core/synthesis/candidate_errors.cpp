#include "core/synthesis/candidate_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiaro::synthesis {

namespace {

constexpr auto worstCost = std::numeric_limits<std::uint32_t>::max();
constexpr double worstTotal = std::numeric_limits<double>::infinity();

template <class Cost>
void exclude(const CandidateArea& all, std::span<const CandidateArea> excluded, std::ptrdiff_t pitch,
             std::vector<Cost>& costs, Cost worst) {
    for (const CandidateArea& area : excluded)
        for (int y = area.y - all.y; y < area.y - all.y + area.height; ++y) {
            const auto row = costs.begin() + y * pitch + area.x - all.x;
            std::fill(row, row + area.width, worst);
        }
}

}  // namespace

CandidateErrors::CandidateErrors(const SearchTexture& source, std::vector<PackedTemplate>& packed,
                                 SearchMemory& memory)
    : m_source(source), m_packed(packed), m_memory(memory) {}

void CandidateErrors::add(const Image<SearchPixel>& pixels, double weight) {
    const double exact = std::round(weight * 1024) / 1024;
    if (exact <= 0) return;
    if (m_weights.size() == m_packed.size()) m_packed.emplace_back();
    PackedTemplate& packed = m_packed[m_weights.size()];
    packTemplate(pixels, m_source, packed);
    if (!packed.empty) m_weights.push_back(exact);
}

void CandidateErrors::compute(const CandidateArea& area, std::span<const CandidateArea> excluded) {
    m_area = area;
    if (single()) {
        computeCosts(m_source, m_packed[0], area, m_memory.costs);
        exclude(area, excluded, costPitch(area), m_memory.costs, worstCost);
        return;
    }
    m_memory.totals.assign(std::size_t(area.width) * std::size_t(area.height), 0);
    for (std::size_t i = 0; i < m_weights.size(); ++i) {
        computeCosts(m_source, m_packed[i], area, m_memory.costs);
        addTotals(m_weights[i]);
    }
    exclude(area, excluded, area.width, m_memory.totals, worstTotal);
}

double CandidateErrors::at(int column, int row) const {
    if (!single()) return m_memory.totals[std::size_t(row * m_area.width + column)];
    const std::uint32_t cost = m_memory.costs[std::size_t(row * costPitch(m_area) + column)];
    return cost == worstCost ? worstTotal : cost;
}

std::vector<std::uint32_t>& CandidateErrors::best(double tolerance) {
    m_memory.places.clear();
    if (single())
        collectCosts(tolerance);
    else
        collectTotals(tolerance);
    return m_memory.places;
}

void CandidateErrors::addTotals(double weight) {
    for (int y = 0; y < m_area.height; ++y) {
        const std::uint32_t* costs = m_memory.costs.data() + y * costPitch(m_area);
        double* totals = m_memory.totals.data() + std::ptrdiff_t(y) * m_area.width;
        for (int x = 0; x < m_area.width; ++x) totals[x] += weight * costs[x];
    }
}

void CandidateErrors::collectCosts(double tolerance) {
    const std::uint32_t* costs = m_memory.costs.data();
    const std::ptrdiff_t pitch = costPitch(m_area);
    const double smallest = kernels::smallestCost(costs, pitch, m_area.width, m_area.height);
    const double limit = std::min(smallest * (1 + tolerance), double(~std::uint32_t{0}));
    kernels::collectCosts(costs, pitch, m_area.width, m_area.height, std::uint32_t(limit), m_memory.places);
}

void CandidateErrors::collectTotals(double tolerance) {
    const double limit = *std::ranges::min_element(m_memory.totals) * (1 + tolerance);
    for (std::size_t place = 0; place < m_memory.totals.size(); ++place)
        if (m_memory.totals[place] <= limit) m_memory.places.push_back(std::uint32_t(place));
}

}  // namespace chiaro::synthesis
