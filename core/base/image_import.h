#pragma once

#include "core/base/helper/handler.h"
#include "core/base/helper/helper_pool.h"
#include "core/base/image_io.h"

namespace chiaro {

/// Reading pictures in a helper. The first functions ask, and check what they are told as they would check a
/// file; the handlers answer in the helper.

DecodedImage importImage(helper::HelperPool& helpers, const std::filesystem::path& path,
                         const ImageLimits& limits, const Task& task);
ImageMetadata importImageMetadata(helper::HelperPool& helpers, const std::filesystem::path& path,
                                  const Task& task);

constexpr const char* imageRequest = "image";
constexpr const char* imageMetadataRequest = "image metadata";
helper::Finding handleImageRequest(helper::PlainReader& request, const Task& task);
helper::Finding handleImageMetadataRequest(helper::PlainReader& request, const Task& task);

}  // namespace chiaro
