#include "core/methods/texture_atlas.h"

#include <algorithm>
#include <numeric>

namespace chiaro::methods {

namespace {

/// Rows on pages of this width; a row is as high as its first rectangle.
TextureAtlas packedRows(const std::vector<glm::ivec2>& sizes, const std::vector<std::size_t>& tallestFirst,
                        int width, int largestSide) {
    TextureAtlas atlas;
    atlas.pageSize.x = width;
    atlas.places.resize(sizes.size());
    atlas.pageCount = 1;
    glm::ivec2 next(0);
    int rowHeight = 0;
    for (const std::size_t i : tallestFirst) {
        const glm::ivec2 size = sizes[i];
        if (next.x + size.x > width) {
            next = {0, next.y + rowHeight};
            rowHeight = 0;
        }
        if (next.y + size.y > largestSide) {
            ++atlas.pageCount;
            next = glm::ivec2(0);
            rowHeight = 0;
        }
        atlas.places[i] = {atlas.pageCount - 1, next};
        next.x += size.x;
        rowHeight = std::max(rowHeight, size.y);
        atlas.pageSize.y = std::max(atlas.pageSize.y, next.y + rowHeight);
    }
    return atlas;
}

}  // namespace

TextureAtlas packAtlas(const std::vector<glm::ivec2>& sizes, int largestSide) {
    std::vector<std::size_t> tallestFirst;
    int widest = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (sizes[i].x <= 0 || sizes[i].y <= 0) continue;
        tallestFirst.push_back(i);
        widest = std::max(widest, sizes[i].x);
    }
    if (widest == 0) return {glm::ivec2(0), 0, std::vector<TextureAtlas::Place>(sizes.size())};
    std::ranges::stable_sort(tallestFirst, std::greater(), [&](std::size_t i) { return sizes[i].y; });
    TextureAtlas best;
    constexpr int steps = 32;
    for (int step = 0; step <= steps; ++step) {
        const int width = widest + (std::max(largestSide, widest) - widest) * step / steps;
        TextureAtlas atlas = packedRows(sizes, tallestFirst, width, largestSide);
        if (best.pageCount == 0 || atlas.texelCount() < best.texelCount()) best = std::move(atlas);
    }
    return best;
}

}  // namespace chiaro::methods
