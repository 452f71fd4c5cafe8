#pragma once

#include "core/base/stored_image.h"

namespace chiaro {

/// readImage and readImageMetadata, inside the module.
StoredImage decodeImage(const std::filesystem::path& path, const ImageLimits& limits,
                        const AllocateValues& allocate);
ImageMetadata decodeMetadata(const std::filesystem::path& path);

}  // namespace chiaro
