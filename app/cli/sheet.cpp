#include "app/cli/sheet.h"

#include <algorithm>

namespace chiaro::cli {

namespace {

void paste(const ColorImage& picture, ColorImage& sheet, int left, int top) {
    for (int y = 0; y < picture.height(); ++y)
        std::copy(picture.row(y).begin(), picture.row(y).end(), sheet.row(top + y).begin() + left);
}

ColorImage tiledOver(const ColorImage& level, glm::vec3 color) {
    const int n = level.width();
    ColorImage tiled(2 * n, 2 * n);
    for (int y = 0; y < 2 * n; ++y)
        for (int x = 0; x < 2 * n; ++x) tiled(x, y) = glm::clamp(level(x % n, y % n) + color, 0.0f, 1.0f);
    return tiled;
}

}  // namespace

ColorImage levelSheet(const synthesis::LevelStack& stack, const gradient::Gradient& gradient) {
    constexpr int columns = 4;
    std::vector<ColorImage> pictures;
    const float count = float(stack.levels.size());
    for (std::size_t i = 0; i < stack.levels.size(); ++i)
        pictures.push_back(tiledOver(stack.levels[i], gradient::lookUp(gradient, (float(i) + 0.5f) / count)));
    return contactSheet(pictures, std::min(columns, int(pictures.size())), 8);
}

ColorImage contactSheet(const std::vector<ColorImage>& pictures, int columns, int gap) {
    int cellWidth = 0;
    int cellHeight = 0;
    for (const ColorImage& picture : pictures) {
        cellWidth = std::max(cellWidth, picture.width() + gap);
        cellHeight = std::max(cellHeight, picture.height() + gap);
    }
    const int rows = (int(pictures.size()) + columns - 1) / columns;
    ColorImage sheet(columns * cellWidth + gap, rows * cellHeight + gap, glm::vec3(1));
    for (int i = 0; i < int(pictures.size()); ++i)
        paste(pictures[std::size_t(i)], sheet, gap + i % columns * cellWidth, gap + i / columns * cellHeight);
    return sheet;
}

}  // namespace chiaro::cli
