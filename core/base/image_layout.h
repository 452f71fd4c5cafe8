#pragma once

#include "core/base/image_io.h"

#include <span>
#include <string>
#include <vector>

namespace chiaro {

/// What a file's channels mean and where its pixels belong: plain rearrangements that readImage is made of.

/// Which of a file's channels make the picture, in the order grey, grey + alpha, RGB or RGB + alpha; empty
/// when none do.
using ChannelChoice = std::vector<int>;

/// R, G, B or Y, and A when there is one; else the same within the first layer that has them ("diffuse.R");
/// else the only channel there is.
ChannelChoice chooseByName(const std::vector<std::string>& names);
/// X and Y, or within the first layer that has them; else R and G: two plain values. Empty when there are
/// none.
ChannelChoice chooseVectors(const std::vector<std::string>& names);
/// For formats whose channels come in a fixed order; `alpha` is the index of coverage, -1 for none.
ChannelChoice chooseByCount(int count, int alpha);

bool allFinite(std::span<const float> values);

/// Divides colour by coverage where there is any.
void unpremultiply(DecodedImage& image);

/// The picture turned as its EXIF orientation (1..8) asks; any other number leaves it alone.
DecodedImage upright(DecodedImage image, int orientation);

/// The picture's pixels with its corner at (x, y) of an empty one of another size; what falls outside is
/// cropped.
DecodedImage placed(const DecodedImage& image, int x, int y, int width, int height);

}  // namespace chiaro
