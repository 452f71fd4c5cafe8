#pragma once

#include "core/synthesis/quilting.h"

namespace chiaro::synthesis {

/// The report's tiling (§4.2): a square picture blended with itself rolled by half its side, by a circular
/// mask, so that it repeats without a seam. Blurs where the two mix. Any side of at least 2 px.
ColorImage tiledByMask(const ColorImage& texture);

/// Wrap-around quilting: `task` made so that it repeats without a seam and without blur. Nothing is filled or
/// masked in it; `task.wrap` is set here.
///
/// A quilt settles only after some blocks: its first row and column, which have fewer neighbours to match,
/// keep to one part of the source and would show as stripes. So a larger picture is quilted that does not
/// wrap, its first rows and columns are dropped, and the cross that is then missing is quilted in between its
/// four sides.
QuiltResult quiltTileable(const QuiltTask& task, const QuiltParams& params, Task::Steps& steps);
/// The same with another engine than quilt().
using QuiltEngine = std::function<QuiltResult(const QuiltTask&, const QuiltParams&)>;
QuiltResult quiltTileable(const QuiltTask& task, const QuiltParams& params, const QuiltEngine& engine);
/// Steps that quiltTileable() counts.
std::size_t tileableBlockCount(const QuiltTask& task, const QuiltParams& params);

}  // namespace chiaro::synthesis
