#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// The inner loops of the block search, compiled once for each instruction set and picked at run time
/// (Google Highway). All arithmetic is on integers and exact, so every instruction set gives the same result.
namespace chiaro::synthesis::kernels {

/// Columns and rows that may be read past the last one asked for: the vectors are not cut at the border.
inline constexpr int columnPadding = 16;
inline constexpr int rowPadding = 16;

/// Rows of a template piece that are multiplied in one go.
inline constexpr int longestPiece = 8;

/// A source texture as the kernels read it.
///
/// A row's bytes are its channels, interleaved and offset to be positive (1..127). A *quad* is four
/// consecutive bytes. Quad (x, phase) starts at byte 3 x + phase, phase 0..2, so quads at consecutive x let
/// one vector hold the same four bytes of the template's neighbourhood for consecutive candidates, and every
/// fourth byte of a template row is the start of some quad: no lane is wasted on a missing fourth channel.
struct PackedSource {
    const std::uint32_t* quads = nullptr;  ///< (x, y, phase) at (3 y + phase) quadPitch + x
    std::ptrdiff_t quadPitch = 0;
    const std::uint32_t* squares =
        nullptr;  ///< integral image of r^2 + g^2 + b^2 modulo 2^32, one wider and higher
    std::ptrdiff_t squaresPitch = 0;
};

/// A vertical run of template quads, at most longestPiece: signed bytes (-63..63), 0 where a pixel doesn't
/// count.
struct TemplatePiece {
    std::ptrdiff_t offset = 0;  ///< from the candidate's own quad to the topmost
    std::array<std::uint32_t, longestPiece> quads{};
};

/// The corners of a rectangle of the template in `squares`, relative to the candidate's own entry.
struct SquaresRectangle {
    std::ptrdiff_t topLeft, topRight, bottomLeft, bottomRight;
};

struct CostRequest {
    PackedSource source;
    int x = 0, y = 0;                                                 ///< the first candidate
    int columns = 0, rows = 0;                                        ///< of candidates
    std::array<std::span<const TemplatePiece>, longestPiece> pieces;  ///< of length 1, 2, ..
    std::span<const SquaresRectangle> rectangles;  ///< whose union are the pixels that count
    std::uint32_t constant = 0;                    ///< added to every cost
    std::uint32_t* costs = nullptr;  ///< candidate (i, j) at j pitch + i; padded as the source is
    std::ptrdiff_t pitch = 0;
};

/// costs = constant + (sum of source squares over the rectangles) - 2 (sum of source bytes times template
/// bytes).
void computeCosts(const CostRequest& request);

std::uint32_t smallestCost(const std::uint32_t* costs, std::ptrdiff_t pitch, int columns, int rows);

/// Appends the places (row * columns + column) of all costs up to a limit, row after row.
void collectCosts(const std::uint32_t* costs, std::ptrdiff_t pitch, int columns, int rows,
                  std::uint32_t limit, std::vector<std::uint32_t>& places);

/// The instruction sets this processor runs, best first, as names for `onlyUseTarget`.
std::vector<const char*> supportedTargets();
/// For tests and benchmarks: searches with this instruction set alone; null goes back to the best.
void onlyUseTarget(const char* name);

}  // namespace chiaro::synthesis::kernels
