#pragma once

#include "core/base/image.h"
#include "core/base/random.h"
#include "core/synthesis/search_kernels.h"

#include <span>
#include <vector>

namespace chiaro::synthesis {

/// A pixel as the search compares it: RGB in 127 steps, -63..63.
struct SearchPixel {
    std::int8_t r = 0, g = 0, b = 0;
    bool counts = false;  ///< in a template: takes part in the error
};

/// A source texture, prepared once for any number of searches. Immutable, so threads may share it.
///
/// The colours are rounded for the search alone: each channel's middle is subtracted and the widest channel
/// fills 127 steps. What is copied into a picture are the texture's own pixels.
class SearchTexture {
public:
    /// Any size; difference RGB.
    explicit SearchTexture(const ColorImage& texture);

    int width() const { return m_pixels.width(); }
    int height() const { return m_pixels.height(); }
    /// A colour in the texture's steps; colours outside its range go to the end of it.
    SearchPixel rounded(const glm::vec3& color) const;
    /// The texture's own pixels, rounded.
    const Image<SearchPixel>& pixels() const { return m_pixels; }
    /// One step, in units of the texture.
    double step() const { return m_step; }
    kernels::PackedSource packed() const;

private:
    void packQuads();
    void integrateSquares();

    Image<SearchPixel> m_pixels;
    glm::vec3 m_middle{0};
    double m_step = 1;
    std::ptrdiff_t m_quadPitch = 0;
    std::ptrdiff_t m_squaresPitch = 0;
    std::vector<std::uint32_t> m_quads;
    std::vector<std::uint32_t> m_squares;
};

/// Positions of a block's top left pixel in the source.
struct CandidateArea {
    int x = 0, y = 0;
    int width = 0, height = 0;  ///< at least 1
    friend bool operator==(const CandidateArea&, const CandidateArea&) = default;
};

/// Pixels that a block should match. Only those that count enter the error; their sum of squared differences
/// is multiplied by the weight, which is rounded to 1/1024.
struct SearchTemplate {
    Image<SearchPixel> pixels;
    double weight = 1;
};

/// Memory that searches of one thread use again.
struct SearchMemory {
    std::vector<std::uint32_t> costs;
    std::vector<double> totals;
    std::vector<std::uint32_t> places;
    std::array<std::vector<kernels::TemplatePiece>, kernels::longestPiece> pieces;
    std::vector<kernels::SquaresRectangle> rectangles;
};

/// What a block is looked for by.
struct SearchQuery {
    std::span<const SearchTemplate> templates;  ///< one or more, at most 256 x 256, inside the source at
                                                ///< every candidate
    CandidateArea candidates;
    std::span<const CandidateArea> excluded;  ///< inside the candidates, never all of them
    double tolerance = 0.1;                   ///< how much more than the smallest an error may be, of it
};

/// Squares of candidates around places that were used already, nearest neighbours first, as large as leaves
/// half of the candidates free, and at most half a block: so that a pattern doesn't come back every few
/// blocks.
std::vector<CandidateArea> excludedAround(std::span<const glm::ivec2> used, const CandidateArea& candidates,
                                          int block);

struct BlockMatch {
    glm::ivec2 position{0};   ///< of the block's top left pixel in the source
    std::size_t choices = 0;  ///< candidates that were good enough
};

/// Picks at random among the candidates whose error is within (1 + tolerance) of the smallest, all candidates
/// compared. With no pixel that counts, among all. Exact on the rounded colours and the same on every
/// processor: the pick depends on the arguments alone.
BlockMatch findBlock(const SearchTexture& source, const SearchQuery& query, Random random,
                     SearchMemory& memory);

}  // namespace chiaro::synthesis
