#pragma once

#include "core/base/image_io.h"

namespace chiaro {

/// readImage and readImageMetadata, inside the module.
DecodedImage decodeImage(const std::filesystem::path& path, const ImageLimits& limits);
ImageMetadata decodeMetadata(const std::filesystem::path& path);

}  // namespace chiaro
