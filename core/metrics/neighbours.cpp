#include "core/metrics/neighbours.h"

#include "core/base/error.h"
#include "core/metrics/batch_search.h"
#include "core/metrics/neighbour_tiles.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <variant>

namespace chiaro::metrics {

namespace {

using kernels::groupLength;
using kernels::groupSize;
using kernels::placeInGroup;

constexpr float infinity = std::numeric_limits<float>::infinity();

constexpr std::size_t largestSource = 16'000'000;  // pixels; the index takes 2.5 GB then

void check(const ColorImage& source, int block) {
    const int width = source.width(), height = source.height();
    if (block < smallestBlock || block > largestBlock)
        throw Error("block", fmt::format("is {} px", block),
                    fmt::format("choose {}..{} px", smallestBlock, largestBlock));
    if (width < block || height < block)
        throw Error("sample",
                    fmt::format("is {} x {} px, smaller than a block of {} px", width, height, block),
                    "choose a larger sample or a smaller block");
    if (source.pixelCount() > largestSource)
        throw Error("sample", fmt::format("is {} x {} px", width, height),
                    fmt::format("the metric takes up to {} megapixels, so scale the sample down",
                                largestSource / 1'000'000));
}

/// The rounded mean of a group's members.
template <class Count>
Descriptor middleOf(const Count* group) {
    Descriptor middle;
    for (std::size_t i = 0; i < descriptorLength; ++i) {
        unsigned sum = groupSize / 2;
        for (std::size_t member = 0; member < groupSize; ++member) sum += group[placeInGroup(i, member)];
        middle[i] = std::uint16_t(sum / groupSize);
    }
    return middle;
}

template <class Count>
void fillRow(Tiles<Count>& tiles, const TileGrid& grid, const BinImage& bins, int tileRow) {
    const std::size_t first = std::size_t(tileRow) * std::size_t(grid.tileColumns);
    for (int line = 0; line < tileSide; ++line) {
        BlockCounter counter(bins, {0, std::min(tileRow * tileSide + line, grid.rows - 1)}, grid.block);
        for (int x = 0; x < grid.tileColumns * tileSide; ++x) {
            if (x > 0 && x < grid.columns) counter.advance();
            pack(counter.descriptor(),
                 tiles.members.data() + (first + std::size_t(x / tileSide)) * groupLength,
                 std::size_t(line * tileSide + x % tileSide));
        }
    }
    for (std::size_t tile = first; tile < first + std::size_t(grid.tileColumns); ++tile) {
        const Descriptor middle = middleOf(tiles.tile(tile));
        std::array<float, groupSize> sums;
        kernels::sumsOfDistances(middle, tiles.tile(tile), 1, infinity, sums.data());
        tiles.radii[tile] = withRoom(std::ranges::max(sums));
        pack(middle, tiles.middles.data() + tile / groupSize * groupLength, tile % groupSize);
    }
}

template <class Count>
Tiles<Count> tilesOf(const TileGrid& grid, const BinImage& bins, const Task& task) {
    const std::size_t count = grid.tileCount();
    Tiles<Count> tiles;
    tiles.members.resize(count * groupLength);
    tiles.middles.resize((count + groupSize - 1) / groupSize * groupLength);
    tiles.radii.resize(count);
    Task::Steps steps(task, std::size_t(grid.tileRows));
    tbb::parallel_for(0, grid.tileRows, [&](int tileRow) {
        task.checkpoint();
        fillRow(tiles, grid, bins, tileRow);
        steps.done();
    });
    return tiles;
}

}  // namespace

struct NeighbourIndex::Impl {
    Impl(const ColorImage& source, int block, const Task& task)
        : width(source.width()), height(source.height()), bins(binsOf(source)), grid(width, height, block) {
        task.report(0.2);
        const BinImage binImage = binned(source, bins);
        if (block * block <= std::numeric_limits<std::uint8_t>::max())
            tiles = tilesOf<std::uint8_t>(grid, binImage, task.part(0.3, 1));
        else
            tiles = tilesOf<std::uint16_t>(grid, binImage, task.part(0.3, 1));
    }

    int width, height;
    Bins bins;
    TileGrid grid;
    std::variant<Tiles<std::uint8_t>, Tiles<std::uint16_t>> tiles;
};

NeighbourIndex::NeighbourIndex(const ColorImage& source, int block, const Task& task) {
    check(source, block);
    m_impl = std::make_unique<const Impl>(source, block, task);
}
NeighbourIndex::~NeighbourIndex() = default;
NeighbourIndex::NeighbourIndex(NeighbourIndex&&) noexcept = default;
NeighbourIndex& NeighbourIndex::operator=(NeighbourIndex&&) noexcept = default;

int NeighbourIndex::block() const {
    return m_impl->grid.block;
}

int NeighbourIndex::width() const {
    return m_impl->width;
}

int NeighbourIndex::height() const {
    return m_impl->height;
}

const Bins& NeighbourIndex::bins() const {
    return m_impl->bins;
}

std::size_t NeighbourIndex::bytes() const {
    return std::visit(
        []<class Count>(const Tiles<Count>& kind) {
            return (kind.members.size() + kind.middles.size()) * sizeof(Count) +
                   kind.radii.size() * sizeof(float);
        },
        m_impl->tiles);
}

std::vector<std::vector<Neighbour>> NeighbourIndex::nearest(std::span<const Descriptor> queries, int count,
                                                            Memory& memory) const {
    if (count < 1) throw Error("neighbours", fmt::format("are {}", count), "ask for at least one");
    std::vector<std::vector<Neighbour>> found;
    std::visit(
        [&]<class Count>(const Tiles<Count>& tiles) {
            for (std::size_t i = 0; i < queries.size(); i += batchSize) {
                const auto batch = queries.subspan(i, std::min(batchSize, queries.size() - i));
                BatchSearch<Count>(m_impl->grid, tiles, batch, std::size_t(count), memory).run(found);
            }
        },
        m_impl->tiles);
    return found;
}

std::vector<Neighbour> NeighbourIndex::nearest(const Descriptor& query, int count) const {
    Memory memory;
    return std::move(nearest(std::span(&query, 1), count, memory).front());
}

}  // namespace chiaro::metrics
