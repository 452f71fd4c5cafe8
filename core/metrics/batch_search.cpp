#include "core/metrics/batch_search.h"

#include <algorithm>
#include <limits>

namespace chiaro::metrics {

using kernels::groupLength;
using kernels::groupSize;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float noLimit = std::numeric_limits<float>::max();
constexpr float visited = infinity;  // beyond any limit, even that
constexpr float shrink = float(1 - 2 * kernels::tolerance);

}  // namespace

void Nearest::add(const Candidate& candidate) {
    if (m_found.size() == m_count && !(candidate < m_found.back())) return;
    m_found.insert(std::ranges::upper_bound(m_found, candidate, std::less<>()), candidate);
    if (m_found.size() > m_count) m_found.pop_back();
}

template <class Count>
BatchSearch<Count>::BatchSearch(const TileGrid& grid, const Tiles<Count>& tiles,
                                std::span<const Descriptor> queries, std::size_t count,
                                NeighbourIndex::Memory& memory)
    : m_grid(grid), m_tiles(tiles), m_memory(memory) {
    const std::size_t padded = tiles.middles.size() / groupLength * groupSize;
    memory.least.resize(queries.size() * padded);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const float toBefore = i > 0 ? sumOf(distance(queries[i - 1], queries[i], grid.block)) : infinity;
        m_queries.push_back(
            {&queries[i], Nearest(count), noLimit, toBefore, memory.least.data() + i * padded});
    }
}

template <class Count>
void BatchSearch<Count>::run(std::vector<std::vector<Neighbour>>& found) {
    findLeast();
    for (Query& query : m_queries) begin(query);
    sweep();
    for (const Query& query : m_queries) {
        std::vector<Neighbour>& neighbours = found.emplace_back();
        m_memory.last.clear();
        for (const Nearest::Candidate& candidate : query.nearest.found()) {
            neighbours.push_back(
                {glm::ivec2(candidate.x, candidate.y) + m_grid.block / 2, candidate.distance});
            m_memory.last.push_back(candidate.y / tileSide * std::uint32_t(m_grid.tileColumns) +
                                    candidate.x / tileSide);
        }
    }
}

/// Some middles at a time, so that they stay near while all queries are compared with them.
template <class Count>
void BatchSearch<Count>::findLeast() {
    constexpr std::size_t groupsAtOnce = 8;
    const std::size_t groups = m_tiles.middles.size() / groupLength;
    for (std::size_t group = 0; group < groups; group += groupsAtOnce) {
        const std::size_t count = std::min(groupsAtOnce, groups - group);
        const std::size_t first = group * groupSize;
        const std::size_t last = std::min(first + count * groupSize, m_grid.tileCount());
        for (const Query& query : m_queries) {
            kernels::sumsOfDistances(*query.descriptor, m_tiles.middles.data() + group * groupLength, count,
                                     infinity, query.least + first);
            for (std::size_t tile = first; tile < last; ++tile)
                query.least[tile] = query.least[tile] * shrink - m_tiles.radii[tile];
        }
    }
}

/// The tiles that promise most.
template <class Count>
std::vector<std::uint32_t> BatchSearch<Count>::promising(const Query& query) const {
    constexpr std::size_t wanted = 6;
    std::vector<std::uint32_t> best;
    const auto nearer = [&](std::uint32_t a, std::uint32_t b) { return query.least[a] < query.least[b]; };
    float limit = infinity;
    for (std::uint32_t tile = 0; tile < m_grid.tileCount(); ++tile) {
        if (!(query.least[tile] < limit)) continue;
        best.insert(std::ranges::upper_bound(best, tile, nearer), tile);
        if (best.size() > wanted) best.pop_back();
        if (best.size() == wanted) limit = query.least[best.back()];
    }
    return best;
}

/// Finds a first few neighbours, whose distance leaves little to look at.
template <class Count>
void BatchSearch<Count>::begin(Query& query) {
    const auto visitOnce = [&](std::uint32_t tile) {
        if (query.least[tile] <= query.limit) visit(tile, query, 0);
        query.least[tile] = visited;
    };
    // What resembled the query before is likely to do so again.
    for (const std::uint32_t tile : m_memory.last)
        if (tile < m_grid.tileCount()) visitOnce(tile);
    if (query.toBefore > query.limit)
        for (const std::uint32_t tile : promising(query)) visitOnce(tile);
    m_memory.last.clear();
    for (const Nearest::Candidate& candidate : query.nearest.found())
        m_memory.last.push_back(candidate.y / tileSide * std::uint32_t(m_grid.tileColumns) +
                                candidate.x / tileSide);
}

template <class Count>
void BatchSearch<Count>::sweep() {
    for (std::uint32_t tile = 0; tile < m_grid.tileCount(); ++tile) {
        float least = -infinity;  // of the query before, from a look at the members
        for (Query& query : m_queries) {
            least -= query.toBefore;
            if (std::max(query.least[tile], least) > query.limit) continue;
            least = visit(tile, query, 2 * query.toBefore);
        }
    }
}

/// Compares the query with a tile's members. Returns a distance that none of them is nearer than; it is exact
/// up to `reach` beyond the limit.
template <class Count>
float BatchSearch<Count>::visit(std::uint32_t tile, Query& query, float reach) {
    std::array<float, groupSize> sums;
    const float cutoff = query.limit + std::min(reach, query.limit);
    kernels::sumsOfDistances(*query.descriptor, m_tiles.tile(tile), 1, cutoff, sums.data());
    const float least = std::ranges::min(sums);
    if (least > query.limit) return least * shrink;
    const std::uint32_t x = tile % std::uint32_t(m_grid.tileColumns) * tileSide;
    const std::uint32_t y = tile / std::uint32_t(m_grid.tileColumns) * tileSide;
    for (std::uint32_t member = 0; member < groupSize; ++member) {
        const std::uint32_t memberX = x + member % tileSide, memberY = y + member / tileSide;
        if (sums[member] > query.limit || memberX >= std::uint32_t(m_grid.columns) ||
            memberY >= std::uint32_t(m_grid.rows))
            continue;
        const Descriptor descriptor = unpacked(m_tiles.tile(tile), member);
        query.nearest.add({distance(*query.descriptor, descriptor, m_grid.block), memberX, memberY});
        query.limit = std::min(sumOf(query.nearest.limit()), noLimit);
    }
    return least * shrink;
}

template class BatchSearch<std::uint8_t>;
template class BatchSearch<std::uint16_t>;

}  // namespace chiaro::metrics
