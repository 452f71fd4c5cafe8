#pragma once

#include "core/metrics/neighbour_tiles.h"
#include "core/metrics/neighbours.h"

#include <span>

namespace chiaro::metrics {

/// Queries that are answered together: each tile that one of them fetches serves the others too.
inline constexpr std::size_t batchSize = 8;

/// The best `count` candidates so far, nearest first, equally near ones in raster order.
class Nearest {
public:
    explicit Nearest(std::size_t count) : m_count(count) {}

    struct Candidate {
        double distance;
        std::uint32_t x, y;  ///< of the block's top left pixel
        friend bool operator<(const Candidate& a, const Candidate& b) {
            return std::tie(a.distance, a.y, a.x) < std::tie(b.distance, b.y, b.x);
        }
    };

    void add(const Candidate& candidate);
    /// What is farther than this is not among them.
    double limit() const {
        return m_found.size() < m_count ? std::numeric_limits<double>::infinity() : m_found.back().distance;
    }
    const std::vector<Candidate>& found() const { return m_found; }

private:
    std::size_t m_count;
    std::vector<Candidate> m_found;
};

/// Answers up to batchSize queries. They are best alike, such as those of neighbouring pixels: where one has
/// looked into a tile, the triangle inequality tells the next, which is a known distance away, how near that
/// tile's members can be.
template <class Count>
class BatchSearch {
public:
    BatchSearch(const TileGrid& grid, const Tiles<Count>& tiles, std::span<const Descriptor> queries,
                std::size_t count, NeighbourIndex::Memory& memory);
    /// Appends each query's neighbours.
    void run(std::vector<std::vector<Neighbour>>& found);

private:
    struct Query {
        const Descriptor* descriptor;
        Nearest nearest;
        float limit;     // what is beyond it needs no look, as the kernels' sums tell it
        float toBefore;  // the distance to the query before it
        float* least;    // of each tile: no member is nearer
    };

    void findLeast();
    std::vector<std::uint32_t> promising(const Query& query) const;
    void begin(Query& query);
    void sweep();
    float visit(std::uint32_t tile, Query& query, float reach);
    float sumOf(double distance) const {
        return withRoom(distance * channelCount * m_grid.block * m_grid.block);
    }

    const TileGrid& m_grid;
    const Tiles<Count>& m_tiles;
    NeighbourIndex::Memory& m_memory;
    std::vector<Query> m_queries;
};

extern template class BatchSearch<std::uint8_t>;
extern template class BatchSearch<std::uint16_t>;

}  // namespace chiaro::metrics
