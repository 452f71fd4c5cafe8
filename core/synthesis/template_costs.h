#pragma once

#include "core/synthesis/search_texture.h"

#include <array>
#include <vector>

namespace chiaro::synthesis {

/// Positions of a block's top left pixel in the source.
struct CandidateArea {
    int x = 0, y = 0;
    int width = 0, height = 0;  ///< at least 1
    friend bool operator==(const CandidateArea&, const CandidateArea&) = default;
};

/// A template as the kernels take it, for one source: the pixels that count, in vertical runs.
struct PackedTemplate {
    bool empty = true;  ///< no pixel counts; the rest means nothing then
    std::array<std::vector<kernels::TemplatePiece>, kernels::longestPiece> pieces;
    std::vector<kernels::SquaresRectangle> rectangles;
    std::uint32_t constant = 0;      ///< what every candidate's cost has in common
    std::vector<std::int8_t> bytes;  ///< memory of the packing
    std::vector<std::uint8_t> counts;
};

/// Packs a template of at most 256 x 256 pixels into `packed`, whose memory is used again.
void packTemplate(const Image<SearchPixel>& pixels, const SearchTexture& source, PackedTemplate& packed);

/// From one row of candidates' costs to the next.
std::ptrdiff_t costPitch(const CandidateArea& area);

/// The sums of squared differences at all candidates of the area: candidate (i, j) at j costPitch + i. The
/// template, which isn't empty, lies inside the source at each of them.
void computeCosts(const SearchTexture& source, const PackedTemplate& packed, const CandidateArea& area,
                  std::vector<std::uint32_t>& costs);

}  // namespace chiaro::synthesis
