#include "core/synthesis/block_grid.h"

#include <algorithm>

namespace chiaro::synthesis {

namespace {

int dividedUp(int value, int divisor) {
    return (value + divisor - 1) / divisor;
}

}  // namespace

BlockGrid::Axis::Axis(int axisLength, int blockSide, int overlapPixels, bool wrap)
    : length(axisLength), block(blockSide), even(wrap), stride(blockSide - overlapPixels) {
    count = even ? dividedUp(length, stride) : std::max(dividedUp(length - overlapPixels, stride), 1);
    widestOverlap = even ? block - length / count : overlapPixels;
}

bool BlockGrid::Axis::overlap(int i, int j) const {
    const int apart = std::abs(start(i) - start(j));
    return apart < block || (even && length - apart < block);
}

BlockGrid::BlockGrid(int width, int height, int block, int overlap, bool wrap)
    : m_columns(width, block, overlap, wrap), m_rows(height, block, overlap, wrap) {}

BlockSite BlockGrid::site(int index) const {
    const glm::ivec2 position(m_columns.start(index % m_columns.count),
                              m_rows.start(index / m_columns.count));
    glm::ivec2 size(m_columns.block, m_rows.block);
    if (!m_columns.even) size = glm::min(size, glm::ivec2(m_columns.length, m_rows.length) - position);
    return {index, position, size};
}

std::pair<int, int> BlockGrid::turn(int index) const {
    const int column = index % m_columns.count, row = index / m_columns.count;
    return {2 * row + column, row};
}

std::vector<int> BlockGrid::earlier(int index, int distance) const {
    const int column = index % m_columns.count, row = index / m_columns.count;
    const auto away = [](const Axis& axis, int i, int j) {
        const int plain = std::abs(i - j);
        return axis.even ? std::min(plain, axis.count - plain) : plain;
    };
    std::vector<std::pair<int, int>> found;
    if (distance <= 0) return {};
    for (int otherRow = 0; otherRow <= row; ++otherRow) {
        // Each block waits for its left and its top right neighbour, so for all that lie before this column.
        const int end = std::min(column + row - otherRow, m_columns.count - 1);
        for (int otherColumn = 0; otherColumn <= end; ++otherColumn) {
            const int apart = std::max(away(m_columns, otherColumn, column), away(m_rows, otherRow, row));
            if (apart > 0 && apart <= distance)
                found.emplace_back(apart, otherRow * m_columns.count + otherColumn);
        }
    }
    std::ranges::sort(found);
    std::vector<int> blocks;
    for (const auto& [apart, other] : found) blocks.push_back(other);
    return blocks;
}

std::vector<std::vector<int>> BlockGrid::successors() const {
    const auto neighbours = [](const Axis& axis) {
        std::vector<std::vector<int>> lists(std::size_t(axis.count));
        for (int i = 0; i < axis.count; ++i)
            for (int j = 0; j < axis.count; ++j)
                if (axis.overlap(i, j)) lists[std::size_t(i)].push_back(j);
        return lists;
    };
    const auto besides = neighbours(m_columns), beyond = neighbours(m_rows);
    std::vector<std::vector<int>> later;
    later.resize(std::size_t(count()));
    for (int index = 0; index < count(); ++index)
        for (const int row : beyond[std::size_t(index / m_columns.count)])
            for (const int column : besides[std::size_t(index % m_columns.count)]) {
                const int other = row * m_columns.count + column;
                if (turn(index) < turn(other)) later[std::size_t(index)].push_back(other);
            }
    return later;
}

}  // namespace chiaro::synthesis
