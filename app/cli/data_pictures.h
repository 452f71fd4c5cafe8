#pragma once

#include "core/base/image_io.h"

namespace chiaro::cli {

/// Pictures that hold data rather than colours, as `--aux` writes them and other programs do.

inline constexpr int greatestId = 0xFFFF;

/// A picture of light, 0 dark to 1 light; the values count as stored, also in EXR, and colours count by their
/// luma. Negative, NaN and transparent pixels (-1) are outside. Throws Error naming the file.
ScalarImage readLight(const std::filesystem::path& path);

/// Object ids or a mask, 8 or 16-bit grey: 0 outside, 1.. the object. Throws Error naming the file when it
/// has colours.
IdImage readIds(const std::filesystem::path& path);

}  // namespace chiaro::cli
