#pragma once

#include "core/metrics/neighbour_kernels.h"

#include <vector>

/// How the neighbour search keeps a source's descriptors.
namespace chiaro::metrics {

inline constexpr int tileSide = 4;
static_assert(tileSide * tileSide == kernels::groupSize);

/// The kernels' sums are compared with a little room, so that their error never drops a neighbour.
inline float withRoom(double sum) {
    return float(sum * (1 + 2 * kernels::tolerance) + 1e-4);
}

/// Where the blocks of a source lie, and the tiles of 4 x 4 neighbouring ones.
struct TileGrid {
    TileGrid(int sourceWidth, int sourceHeight, int blockSize)
        : block(blockSize),
          columns(sourceWidth - blockSize + 1),
          rows(sourceHeight - blockSize + 1),
          tileColumns((columns + tileSide - 1) / tileSide),
          tileRows((rows + tileSide - 1) / tileSide) {}
    std::size_t tileCount() const { return std::size_t(tileColumns) * std::size_t(tileRows); }

    int block;
    int columns, rows;  // of blocks
    int tileColumns, tileRows;
};

/// All descriptors of a source; `Count` is a byte where a block has at most 255 pixels.
template <class Count>
struct Tiles {
    std::vector<Count> members;  ///< a group a tile, members row by row; the last column and row again where
                                 ///< a tile reaches beyond them
    std::vector<Count> middles;  ///< groups of the tiles' middles
    std::vector<float> radii;    ///< of each tile: no member is farther from its middle

    const Count* tile(std::size_t index) const { return members.data() + index * kernels::groupLength; }
};

template <class Count>
void pack(const Descriptor& descriptor, Count* group, std::size_t member) {
    for (std::size_t i = 0; i < descriptorLength; ++i)
        group[kernels::placeInGroup(i, member)] = static_cast<Count>(descriptor[i]);
}

template <class Count>
Descriptor unpacked(const Count* group, std::size_t member) {
    Descriptor descriptor;
    for (std::size_t i = 0; i < descriptorLength; ++i)
        descriptor[i] = group[kernels::placeInGroup(i, member)];
    return descriptor;
}

}  // namespace chiaro::metrics
