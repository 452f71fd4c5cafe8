#include "core/metrics/neighbours.h"

#include "core/base/error.h"
#include "core/metrics/neighbour_kernels.h"

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

constexpr int tileSide = 4;
static_assert(tileSide * tileSide == groupSize);

constexpr std::size_t largestSource = 16'000'000;  // pixels; the index takes 2.5 GB then

/// The kernels' sums are compared with a little room, so that their error never drops a neighbour.
float withRoom(double sum) {
    return float(sum * (1 + 2 * kernels::tolerance) + 1e-4);
}

/// The best `count` candidates so far, nearest first, equally near ones in order of their place.
class Nearest {
public:
    explicit Nearest(std::size_t count) : m_count(count) {}

    struct Candidate {
        double distance;
        std::uint32_t x, y;  // of the block's top left pixel
        friend bool operator<(const Candidate& a, const Candidate& b) {
            return std::tie(a.distance, a.y, a.x) < std::tie(b.distance, b.y, b.x);
        }
    };

    void add(const Candidate& candidate) {
        if (m_found.size() == m_count && !(candidate < m_found.back())) return;
        m_found.insert(std::ranges::upper_bound(m_found, candidate, std::less<>()), candidate);
        if (m_found.size() > m_count) m_found.pop_back();
    }
    /// What is farther than this is not among them.
    double limit() const {
        return m_found.size() < m_count ? std::numeric_limits<double>::infinity() : m_found.back().distance;
    }
    const std::vector<Candidate>& found() const { return m_found; }

private:
    std::size_t m_count;
    std::vector<Candidate> m_found;
};

/// The tiles, their counts as bytes where a block has at most 255 pixels.
template <class Count>
struct Tiles {
    std::vector<Count> members;  ///< a group a tile, members row by row
    std::vector<Count> middles;  ///< groups of the tiles' middles
    std::vector<float> radii;    ///< of each tile: no member is farther from its middle

    const Count* tile(std::size_t index) const { return members.data() + index * groupLength; }
};

template <class Count>
void pack(const Descriptor& descriptor, Count* group, std::size_t member) {
    for (std::size_t i = 0; i < descriptorLength; ++i)
        group[placeInGroup(i, member)] = static_cast<Count>(descriptor[i]);
}

template <class Count>
Descriptor unpacked(const Count* group, std::size_t member) {
    Descriptor descriptor;
    for (std::size_t i = 0; i < descriptorLength; ++i) descriptor[i] = group[placeInGroup(i, member)];
    return descriptor;
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

}  // namespace

struct NeighbourIndex::Impl {
    Impl(const ColorImage& source, int blockSize, const Task& task)
        : block(blockSize), width(source.width()), height(source.height()) {
        check();
        bins = binsOf(source);
        columns = width - block + 1;
        rows = height - block + 1;
        tileColumns = (columns + tileSide - 1) / tileSide;
        tileRows = (rows + tileSide - 1) / tileSide;
        task.report(0.2);
        const BinImage binImage = binned(source, bins);
        if (block * block > std::numeric_limits<std::uint8_t>::max()) tiles = Tiles<std::uint16_t>();
        std::visit([&](auto& kind) { fill(kind, binImage, task.part(0.3, 1)); }, tiles);
    }

    void check() const {
        if (block < smallestBlock || block > largestBlock)
            throw Error("block", fmt::format("is {} px", block),
                        fmt::format("choose {}..{} px", smallestBlock, largestBlock));
        if (width < block || height < block)
            throw Error("sample",
                        fmt::format("is {} x {} px, smaller than a block of {} px", width, height, block),
                        "choose a larger sample or a smaller block");
        if (std::size_t(width) * std::size_t(height) > largestSource)
            throw Error("sample", fmt::format("is {} x {} px", width, height),
                        fmt::format("the metric takes up to {} megapixels, so scale the sample down",
                                    largestSource / 1'000'000));
    }

    template <class Count>
    void fill(Tiles<Count>& kind, const BinImage& binImage, const Task& task) {
        const std::size_t count = tileCount();
        kind.members.resize(count * groupLength);
        kind.middles.resize((count + groupSize - 1) / groupSize * groupLength);
        kind.radii.resize(count);
        Task::Steps steps(task, std::size_t(tileRows));
        tbb::parallel_for(0, tileRows, [&](int tileRow) {
            task.checkpoint();
            fillRow(kind, binImage, tileRow);
            steps.done();
        });
    }

    template <class Count>
    void fillRow(Tiles<Count>& kind, const BinImage& binImage, int tileRow) const {
        const std::size_t first = std::size_t(tileRow) * std::size_t(tileColumns);
        // Tiles at the right and bottom are filled up with their last column and row.
        for (int line = 0; line < tileSide; ++line) {
            BlockCounter counter(binImage, {0, std::min(tileRow * tileSide + line, rows - 1)}, block);
            for (int x = 0; x < tileColumns * tileSide; ++x) {
                if (x > 0 && x < columns) counter.advance();
                pack(counter.descriptor(),
                     kind.members.data() + (first + std::size_t(x / tileSide)) * groupLength,
                     std::size_t(line * tileSide + x % tileSide));
            }
        }
        for (std::size_t tile = first; tile < first + std::size_t(tileColumns); ++tile) {
            const Descriptor middle = middleOf(kind.tile(tile));
            std::array<float, groupSize> sums;
            kernels::sumsOfDistances(middle, kind.tile(tile), 1, std::numeric_limits<float>::infinity(),
                                     sums.data());
            kind.radii[tile] = withRoom(std::ranges::max(sums));
            pack(middle, kind.middles.data() + tile / groupSize * groupLength, tile % groupSize);
        }
    }

    std::size_t tileCount() const { return std::size_t(tileColumns) * std::size_t(tileRows); }

    /// A distance as the kernels' sums tell it, with room.
    float limitOf(double distance) const { return withRoom(distance * channelCount * block * block); }

    /// Compares the query with a tile's members.
    template <class Count>
    void visit(const Tiles<Count>& kind, std::uint32_t tile, const Descriptor& query,
               Nearest& nearest) const {
        std::array<float, groupSize> sums;
        kernels::sumsOfDistances(query, kind.tile(tile), 1, limitOf(nearest.limit()), sums.data());
        const std::uint32_t x = tile % std::uint32_t(tileColumns) * tileSide;
        const std::uint32_t y = tile / std::uint32_t(tileColumns) * tileSide;
        for (std::uint32_t member = 0; member < groupSize; ++member) {
            const std::uint32_t memberX = x + member % tileSide, memberY = y + member / tileSide;
            if (sums[member] > limitOf(nearest.limit()) || memberX >= std::uint32_t(columns) ||
                memberY >= std::uint32_t(rows))
                continue;
            nearest.add({distance(query, unpacked(kind.tile(tile), member), block), memberX, memberY});
        }
    }

    /// For each tile the least distance that a member of it may have, as the kernels' sums tell it.
    template <class Count>
    void findLeast(const Tiles<Count>& kind, const Descriptor& query, std::vector<float>& least) const {
        constexpr float shrink = float(1 - 2 * kernels::tolerance);
        least.resize(kind.middles.size() / groupLength * groupSize);
        kernels::sumsOfDistances(query, kind.middles.data(), least.size() / groupSize,
                                 std::numeric_limits<float>::infinity(), least.data());
        for (std::size_t tile = 0; tile < tileCount(); ++tile)
            least[tile] = least[tile] * shrink - kind.radii[tile];
    }

    /// The tiles that promise most; visited first, they leave little of the others.
    std::vector<std::uint32_t> promising(const std::vector<float>& least) const {
        constexpr std::size_t wanted = 6;
        std::vector<std::uint32_t> best;
        const auto nearer = [&](std::uint32_t a, std::uint32_t b) { return least[a] < least[b]; };
        float limit = std::numeric_limits<float>::infinity();
        for (std::uint32_t tile = 0; tile < tileCount(); ++tile) {
            if (!(least[tile] < limit)) continue;
            best.insert(std::ranges::upper_bound(best, tile, nearer), tile);
            if (best.size() > wanted) best.pop_back();
            if (best.size() == wanted) limit = least[best.back()];
        }
        return best;
    }

    template <class Count>
    std::vector<Neighbour> find(const Tiles<Count>& kind, const Descriptor& query, int count,
                                Memory& memory) const {
        std::vector<float>& least = memory.least;
        findLeast(kind, query, least);
        Nearest nearest{std::size_t(count)};
        const auto visitOnce = [&](std::uint32_t tile) {
            if (least[tile] <= limitOf(nearest.limit())) visit(kind, tile, query, nearest);
            least[tile] = std::numeric_limits<float>::infinity();
        };
        // What resembled the query before is likely to do so again, for queries from neighbouring pixels.
        for (const std::uint32_t tile : memory.last)
            if (tile < tileCount()) visitOnce(tile);
        for (const std::uint32_t tile : promising(least)) visitOnce(tile);
        const auto currentLimit = [&] {
            return std::min(limitOf(nearest.limit()), std::numeric_limits<float>::max());
        };
        float limit = currentLimit();
        for (std::uint32_t tile = 0; tile < tileCount(); ++tile)
            if (least[tile] <= limit) {
                visitOnce(tile);
                limit = currentLimit();
            }
        std::vector<Neighbour> neighbours;
        memory.last.clear();
        for (const Nearest::Candidate& candidate : nearest.found()) {
            neighbours.push_back({glm::ivec2(candidate.x, candidate.y) + block / 2, candidate.distance});
            memory.last.push_back(candidate.y / tileSide * std::uint32_t(tileColumns) +
                                  candidate.x / tileSide);
        }
        return neighbours;
    }

    int block;
    int width, height;
    Bins bins{};
    int columns = 0, rows = 0;  // of blocks
    int tileColumns = 0, tileRows = 0;
    std::variant<Tiles<std::uint8_t>, Tiles<std::uint16_t>> tiles;
};

NeighbourIndex::NeighbourIndex(const ColorImage& source, int block, const Task& task)
    : m_impl(std::make_unique<const Impl>(source, block, task)) {}
NeighbourIndex::~NeighbourIndex() = default;
NeighbourIndex::NeighbourIndex(NeighbourIndex&&) noexcept = default;
NeighbourIndex& NeighbourIndex::operator=(NeighbourIndex&&) noexcept = default;

int NeighbourIndex::block() const {
    return m_impl->block;
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

std::vector<Neighbour> NeighbourIndex::nearest(const Descriptor& query, int count, Memory& memory) const {
    if (count < 1) throw Error("neighbours", fmt::format("are {}", count), "ask for at least one");
    return std::visit([&](const auto& kind) { return m_impl->find(kind, query, count, memory); },
                      m_impl->tiles);
}

std::vector<Neighbour> NeighbourIndex::nearest(const Descriptor& query, int count) const {
    Memory memory;
    return nearest(query, count, memory);
}

}  // namespace chiaro::metrics
