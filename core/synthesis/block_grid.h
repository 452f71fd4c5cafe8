#pragma once

#include "core/synthesis/quilting.h"

#include <algorithm>
#include <vector>

namespace chiaro::synthesis {

/// How a picture is divided into overlapping blocks, and in which order they go.
///
/// Blocks are placed along anti-diagonals that fall by one row for two columns. A block then finds its left,
/// top left, top and top right neighbours in place, as in raster order, and the blocks of a diagonal don't
/// touch. In a picture that wraps, the blocks are spread evenly and the last of a row and column find the
/// first in place.
class BlockGrid {
public:
    BlockGrid(int width, int height, int block, int overlap, bool wrap);

    int columns() const { return m_columns.count; }
    int count() const { return m_columns.count * m_rows.count; }
    BlockSite site(int index) const;
    /// The widest overlap of two neighbours.
    int widestOverlap() const { return std::max(m_columns.widestOverlap, m_rows.widestOverlap); }

    /// Blocks at most `distance` columns and rows away that are in place whenever `index` is placed, on
    /// however many threads; nearest first.
    std::vector<int> earlier(int index, int distance) const;
    /// The blocks that must wait for each block, since they overlap with it and come later.
    std::vector<std::vector<int>> successors() const;

private:
    // Blocks along one axis.
    struct Axis {
        Axis(int length, int block, int overlap, bool wrap);
        int start(int i) const { return even ? int(std::int64_t(i) * length / count) : i * stride; }
        bool overlap(int i, int j) const;

        int length;
        int block;
        bool even;  // wraps around, with starts spread evenly
        int stride;
        int count;
        int widestOverlap;
    };

    std::pair<int, int> turn(int index) const;

    Axis m_columns;
    Axis m_rows;
};

}  // namespace chiaro::synthesis
