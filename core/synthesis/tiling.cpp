#include "core/synthesis/tiling.h"

#include "core/synthesis/block_grid.h"

#include <algorithm>

namespace chiaro::synthesis {

namespace {

// M = 255 - 255 r / (n/2), r the distance from the centre, clipped to [1, 255].
float maskAt(int x, int y, int side) {
    const float half = float(side) / 2;
    const float distance = std::hypot(float(x) + 0.5f - half, float(y) + 0.5f - half);
    return std::clamp(255 - 255 * distance / half, 1.0f, 255.0f);
}

}  // namespace

ColorImage tiledByMask(const ColorImage& texture) {
    const int side = texture.width();
    ColorImage tiled(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int rolledX = (x + side / 2) % side, rolledY = (y + side / 2) % side;
            const float mask = maskAt(x, y, side), rolledMask = maskAt(rolledX, rolledY, side);
            tiled(x, y) =
                (texture(x, y) * mask + texture(rolledX, rolledY) * rolledMask) / (mask + rolledMask);
        }
    return tiled;
}

namespace {

// One axis of a picture that wraps: a gap is left at its beginning, and what comes before the gap is what
// follows the end of the picture it was cut from.
struct Gap {
    Gap(int axisLength, const QuiltParams& params) : length(axisLength) {
        const BlockGrid grid(length, length, params.block, params.overlapPixels(), true);
        begin = grid.widestOverlap();
        end = std::max(grid.site(std::clamp(grid.columns() / 5, 1, 3)).position.x, begin);
    }
    bool contains(int x) const { return x >= begin && x < end; }
    int cutFrom(int x) const { return x < begin ? x + length : x; }

    int length;
    int begin;
    int end;
};

QuiltTask wrapped(QuiltTask task) {
    task.wrap = true;
    return task;
}

// The larger picture that doesn't wrap.
QuiltTask extended(QuiltTask task, const Gap& columns, const Gap& rows) {
    task.wrap = false;
    task.width += columns.begin;
    task.height += rows.begin;
    return task;
}

}  // namespace

std::size_t tileableBlockCount(const QuiltTask& task, const QuiltParams& params) {
    const QuiltParams fitted = fittedBlock(params, wrapped(task));
    const Gap columns(task.width, fitted), rows(task.height, fitted);
    return blockCount(extended(task, columns, rows), fitted) + blockCount(wrapped(task), fitted);
}

QuiltResult quiltTileable(const QuiltTask& task, const QuiltParams& params, Task::Steps& steps) {
    return quiltTileable(task, params, [&steps](const QuiltTask& part, const QuiltParams& fitted) {
        return quilt(part, fitted, steps);
    });
}

QuiltResult quiltTileable(const QuiltTask& task, const QuiltParams& params, const QuiltEngine& engine) {
    const QuiltParams fitted = fittedBlock(params, wrapped(task));
    const Gap columns(task.width, fitted), rows(task.height, fitted);
    const QuiltResult settled = engine(extended(task, columns, rows), fitted);

    ColorImage filled(task.width, task.height);
    PixelMask where(task.width, task.height, 0);
    for (int y = 0; y < task.height; ++y)
        for (int x = 0; x < task.width; ++x) {
            where(x, y) = !columns.contains(x) && !rows.contains(y);
            filled(x, y) = settled.texture(columns.cutFrom(x), rows.cutFrom(y));
        }
    QuiltTask closing = wrapped(task);
    closing.filled = &filled;
    closing.filledWhere = &where;
    QuiltResult result = engine(closing, fitted);
    for (int y = 0; y < task.height; ++y)
        for (int x = 0; x < task.width; ++x)
            if (result.origin(x, y).x < 0)
                result.origin(x, y) = settled.origin(columns.cutFrom(x), rows.cutFrom(y));
    result.blocks.insert(result.blocks.begin(), settled.blocks.begin(), settled.blocks.end());
    return result;
}

}  // namespace chiaro::synthesis
