#pragma once

#include "core/base/image.h"

#include <array>
#include <cstdint>

namespace chiaro::metrics {

/// What a picture looks like around a pixel (§5.1): 15 channels, each counted into 10 bins over a block.

inline constexpr int channelCount = 15;  ///< 5 images (colour, 4 edge images) x RGB
inline constexpr int binCount = 10;
inline constexpr int descriptorLength = channelCount * binCount;

inline constexpr int smallestBlock = 4;
inline constexpr int largestBlock = 16;

/// Whole numbers, so that sums are exact and ties fall the same way on every machine: colours count in steps
/// of 1/65535, which holds 8-bit and 16-bit pictures without rounding.
using ChannelImage = Image<std::array<std::int32_t, channelCount>>;

/// The 15 channels of a picture, display-referred RGB in [0, 1]: channel 3 i + c is image i of RGB channel c.
/// Image 0 is the picture, 1 its vertical edges [-1 0 1; -1 0 1; -1 0 1], 2 the horizontal ones [-1 -1 -1;
/// 0 0 0; 1 1 1], 3 and 4 the diagonals [0 0 3; 0 0 0; -3 0 0] and [-3 0 0; 0 0 0; 0 0 3]; by correlation,
/// with the border replicated. Values outside [0, 1] are clipped, NaN counts as 0.
ChannelImage channelImages(const ColorImage& picture);

/// Where each channel is divided into bins.
///
/// Edge k = 1..9 of a channel is the k/10 quantile of all N values that the source has there: with v sorted
/// and p = k (N - 1) / 10, v[floor p] + (p - floor p) (v[floor p + 1] - v[floor p]), computed exactly. A
/// value belongs to bin number (edges that are <= it): 0..9. So a value that equals an edge goes up, and
/// equal edges leave the bins between them empty. (numpy.quantile and numpy.searchsorted(side="right").)
struct Bins {
    /// The smallest whole number that isn't below the edge, which parts whole numbers just as the edge does.
    std::array<std::array<std::int32_t, binCount - 1>, channelCount> edges;
    friend bool operator==(const Bins&, const Bins&) = default;
};

/// The bins of a source: its pixels spread evenly over them. Throws Error when it is empty or of one colour.
Bins binsOf(const ColorImage& source);

/// Each pixel's bin in each channel.
using BinImage = Image<std::array<std::uint8_t, channelCount>>;

/// A picture's channels in a source's bins.
BinImage binned(const ColorImage& picture, const Bins& bins);

/// The counts of 15 histograms, 10 bins each, over a block; each histogram sums to the block's pixels.
using Descriptor = std::array<std::uint16_t, descriptorLength>;

/// The block of `size` x `size` pixels (4..16) around a pixel, which stands at index size / 2 of it.
struct Block {
    Block(glm::ivec2 pixel, int side) : corner(pixel - side / 2), size(side) {}
    bool isInside(int width, int height) const {
        return corner.x >= 0 && corner.y >= 0 && corner.x + size <= width && corner.y + size <= height;
    }
    glm::ivec2 corner;  ///< its top left pixel
    int size;
};

/// The descriptor of a block that lies inside the picture.
Descriptor describe(const BinImage& bins, const Block& block);

/// Counts the blocks of one row after the other, each from the one before it.
class BlockCounter {
public:
    /// Begins with the block whose top left pixel is `corner`; it lies inside the picture.
    BlockCounter(const BinImage& bins, glm::ivec2 corner, int size);
    const Descriptor& descriptor() const { return m_descriptor; }
    /// On to the block one pixel to the right, which lies inside the picture too.
    void advance();

private:
    const BinImage& m_bins;
    Block m_block;
    Descriptor m_descriptor;
};

/// d (§5.1): the Euclidean distances of the 15 pairs of histograms, added up and divided by 15 size^2. A
/// metric: symmetric, 0 for equal descriptors, at most sqrt(2).
double distance(const Descriptor& a, const Descriptor& b, int size);

}  // namespace chiaro::metrics
