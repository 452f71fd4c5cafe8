#pragma once

#include "core/base/image.h"
#include "core/base/parameters.h"
#include "core/base/task.h"
#include "core/synthesis/block_search.h"

#include <cstdint>
#include <functional>

namespace chiaro::synthesis {

/// Image quilting (Efros and Freeman 2001), shared by all methods.
struct QuiltParams {
    int block = 32;          ///< side of a block, 4..256 px
    int overlap = 0;         ///< px; 0 is automatic: round(block / 6), at least 2
    double tolerance = 0.1;  ///< pick at random among candidates within (1 + tolerance) of the smallest error
    std::uint64_t seed = 1;
    static const ParameterTable<QuiltParams>& table();
    /// The overlap in use: at most half a block.
    int overlapPixels() const;
    friend bool operator==(const QuiltParams&, const QuiltParams&) = default;
};

/// What was made, and how well it fits.
struct QuiltReport {
    std::size_t blocks = 0;
    double overlapError = 0;  ///< mean squared RGB difference over the overlap pixels, before the cut
};

/// 0 where a pixel doesn't take part, anything else where it does.
using PixelMask = Image<std::uint8_t>;

/// Where a block goes.
struct BlockSite {
    int index = 0;           ///< counts blocks row by row; decides, with the seed, the random choice
    glm::ivec2 position{0};  ///< of its top left pixel in the picture
    glm::ivec2 size{0};      ///< of the part inside the picture: smaller than a block at the right and bottom
};

/// A block that was placed.
struct PlacedBlock {
    BlockSite site;
    glm::ivec2 source{0};           ///< where its top left pixel came from
    std::size_t overlapPixels = 0;  ///< pixels that were there before it
    double overlapError = 0;        ///< sum over them of the squared RGB difference, r^2 + g^2 + b^2
};

/// What to quilt. The pictures that pointers lead to are as large as the picture to make, and may be absent.
struct QuiltTask {
    const ColorImage* source = nullptr;  ///< difference RGB, at least a block large (see fittedBlock)
    /// The source prepared for searches, where several pictures are made of it; without it that is done anew
    const SearchTexture* prepared = nullptr;
    int width = 0, height = 0;           ///< of the picture
    bool wrap = false;                   ///< make it tile: the last blocks meet the first, in both directions
    const PixelMask* valid = nullptr;    ///< pixels to make; all without it. Others never count nor change
    const ColorImage* filled = nullptr;  ///< pixels that are there already,
    const PixelMask* filledWhere = nullptr;    ///< and where
    const ColorImage* previous = nullptr;      ///< a picture to stay close to: the frame before
    const PixelMask* previousWhere = nullptr;  ///< where that says something; everywhere without it
    double previousWeight = 0;  ///< of its mean squared error, against the overlap's mean squared error
    /// Blocks within which a place of the source isn't used twice, where there is choice: against a pattern
    /// that comes back every few blocks; 0 lets it
    int variety = 0;
    /// Which source positions a block may come from, of those at which it lies inside the source; all without
    /// it. Called from several threads at once.
    std::function<CandidateArea(const BlockSite&)> candidates;
};

struct QuiltResult {
    ColorImage texture;               ///< 0 where nothing was made
    Image<glm::i16vec2> origin;       ///< the source pixel of each pixel; -1 where it isn't from the source
    std::vector<PlacedBlock> blocks;  ///< in order of their index
    QuiltReport report() const;
};

/// The params with a block (and overlap) that leaves some choice: at most three quarters of the source's
/// smaller side when the block asked for doesn't fit into it, and half the picture when that wraps around.
QuiltParams fittedBlock(const QuiltParams& params, const QuiltTask& task);

/// Blocks a picture is divided into, those without a valid pixel included: steps that quilt() reports.
std::size_t blockCount(const QuiltTask& task, const QuiltParams& params);

/// Makes a picture of a source's texture. Blocks in raster order, a block skipped where nothing valid is
/// missing; anti-diagonals run in parallel. The bytes depend on task and params alone. Throws Error when
/// there is no source, Cancelled.
QuiltResult quilt(const QuiltTask& task, const QuiltParams& params, const Task& progress = {});
/// The same, counting its blocks in a larger work's steps.
QuiltResult quilt(const QuiltTask& task, const QuiltParams& params, Task::Steps& steps);

}  // namespace chiaro::synthesis
