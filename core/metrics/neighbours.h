#pragma once

#include "core/base/task.h"
#include "core/metrics/descriptor.h"

#include <memory>
#include <span>
#include <vector>

namespace chiaro::metrics {

/// A pixel of the source that resembles a query.
struct Neighbour {
    glm::ivec2 pixel{0};  ///< of the source; its block lies inside
    double distance = 0;  ///< d (§5.1), 0..sqrt(2)
    friend bool operator==(const Neighbour&, const Neighbour&) = default;
};

/// All descriptors of a source, prepared for exact nearest-neighbour searches under d. Immutable, so threads
/// may share it.
///
/// Descriptors of neighbouring pixels are alike, so they are kept in tiles of 4 x 4, each with a middle and
/// the distance of its farthest member from there. d obeys the triangle inequality: a query compares itself
/// with the middles, and then only with the tiles that may still hold something nearer than what it has. In
/// 150 dimensions nearly without structure that beats trees and projections by far.
class NeighbourIndex {
public:
    /// Memory that the searches of one thread use again; what it holds only makes them faster.
    struct Memory {
        std::vector<float> least;
        std::vector<std::uint32_t> last;
    };

    /// Takes about 160 bytes a pixel of the source (320 for a block of 16). Throws Error when the source is
    /// smaller than a block, of one colour or beyond 16 megapixels, or when the block is not 4..16 px;
    /// Cancelled.
    explicit NeighbourIndex(const ColorImage& source, int block = 8, const Task& task = {});
    ~NeighbourIndex();
    NeighbourIndex(NeighbourIndex&&) noexcept;
    NeighbourIndex& operator=(NeighbourIndex&&) noexcept;

    int block() const;
    /// Of the source, in pixels.
    int width() const;
    int height() const;
    /// The source's bins, in which what is looked for must be described too.
    const Bins& bins() const;
    std::size_t bytes() const;

    /// The `count` source pixels nearest to a descriptor of the same block size, nearest first, equally near
    /// ones in raster order; fewer when the source has fewer. Exact, and the same on every processor.
    std::vector<Neighbour> nearest(const Descriptor& query, int count) const;
    /// The same for many queries, faster when those that follow each other are alike.
    std::vector<std::vector<Neighbour>> nearest(std::span<const Descriptor> queries, int count,
                                                Memory& memory) const;

    struct Impl;

private:
    std::unique_ptr<const Impl> m_impl;
};

}  // namespace chiaro::metrics
