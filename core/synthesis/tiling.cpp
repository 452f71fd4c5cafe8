#include "core/synthesis/tiling.h"

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

}  // namespace chiaro::synthesis
