#pragma once

#include "core/base/image.h"
#include "core/base/task.h"

namespace chiaro::metrics {

/// The distortions on which the metric is tried (§5.1). All keep the picture's size and its centre, and are
/// deterministic.

/// Turned about its centre, clockwise, by degrees; Lanczos, quarter turns exactly. Beyond the picture's
/// border it is mirrored.
ColorImage rotated(const ColorImage& picture, double degrees);

/// Enlarged (factor > 1) or shrunk about its centre; shrunk by area, enlarged by Lanczos, 1 exactly. Factors
/// are 0.1..10. Where a shrunk picture doesn't reach, it is mirrored.
ColorImage scaled(const ColorImage& picture, double factorX, double factorY);

/// Quilted anew from blocks of `block` x `block` px (4..256), with boundary cuts, each block taken at random
/// from the stripe of width 2 block about where it goes: the smaller the blocks, the more the texture is
/// torn. Throws Error when the picture is smaller than a block; Cancelled.
ColorImage torn(const ColorImage& picture, int block, std::uint64_t seed, const Task& task = {});

/// 1 in a disc about the picture's centre, 0 elsewhere.
IdImage centralDisc(int width, int height, double radius);

/// Textures of size x size px on which the metric's behaviour is known.

/// Smooth noise, the same in every direction.
ColorImage randomTexture(int size, std::uint64_t seed);
/// Stripes at 45 degrees, regular but for a jitter of their edges.
ColorImage diagonalTexture(int size, std::uint64_t seed);
/// Round dots at random places, the same in every direction.
ColorImage symmetricTexture(int size, std::uint64_t seed);

}  // namespace chiaro::metrics
