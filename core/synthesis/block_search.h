#pragma once

#include "core/base/image.h"
#include "core/base/random.h"
#include "core/synthesis/candidate_errors.h"

#include <span>
#include <vector>

namespace chiaro::synthesis {

/// Pixels that a block should match. Only those that count enter the error; their sum of squared differences
/// is multiplied by the weight, which is rounded to 1/1024.
struct SearchTemplate {
    Image<SearchPixel> pixels;
    double weight = 1;
};

/// What a block is looked for by.
struct SearchQuery {
    std::span<const SearchTemplate> templates;  ///< one or more, at most 256 x 256, inside the source at
                                                ///< every candidate
    CandidateArea candidates;
    std::span<const CandidateArea> excluded;  ///< inside the candidates, never all of them
    double tolerance = 0.1;                   ///< how much more than the smallest an error may be, of it
    bool draft = false;                       ///< compare at half the size first, see findBlock
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
///
/// A draft compares every second candidate in each direction at half the size of source and templates, and
/// then exactly those about the best few; it picks among these. Where there are few candidates it is exact.
BlockMatch findBlock(const SearchTexture& source, const SearchQuery& query, Random random,
                     SearchMemory& memory);

}  // namespace chiaro::synthesis
