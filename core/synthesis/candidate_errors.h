#pragma once

#include "core/synthesis/template_costs.h"

#include <span>
#include <vector>

namespace chiaro::synthesis {

/// Memory that searches of one thread use again.
struct SearchMemory {
    std::vector<PackedTemplate> packed, halfPacked;
    std::vector<std::uint32_t> costs;
    std::vector<double> totals;
    std::vector<std::uint32_t> places;
};

/// The errors of candidates against the weighted sum of templates. Exact: costs are whole and weights
/// multiples of 1/1024.
class CandidateErrors {
public:
    /// `packed` keeps the templates; `memory` the errors of the latest area, whoever computed them.
    CandidateErrors(const SearchTexture& source, std::vector<PackedTemplate>& packed, SearchMemory& memory);

    void add(const Image<SearchPixel>& pixels, double weight);
    /// No pixel counts: all candidates are as good.
    bool empty() const { return m_weights.empty(); }

    /// The errors of all candidates of an area. Excluded ones, which lie inside it, get the largest number.
    void compute(const CandidateArea& area, std::span<const CandidateArea> excluded);
    /// The error of a candidate of the area; infinity when excluded.
    double at(int column, int row) const;
    /// The places (row * width + column), row after row, whose error is within (1 + tolerance) of the
    /// smallest.
    std::vector<std::uint32_t>& best(double tolerance);

private:
    bool single() const { return m_weights.size() == 1 && m_weights[0] == 1; }
    void addTotals(double weight);
    void collectCosts(double tolerance);
    void collectTotals(double tolerance);

    const SearchTexture& m_source;
    std::vector<PackedTemplate>& m_packed;
    SearchMemory& m_memory;
    std::vector<double> m_weights;
    CandidateArea m_area;
};

}  // namespace chiaro::synthesis
