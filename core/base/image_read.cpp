#include "core/base/codec/codec.h"
#include "core/base/image_format.h"
#include "core/base/image_io.h"

namespace chiaro {

namespace fs = std::filesystem;

DecodedImage readImage(const fs::path& path, const ImageLimits& limits) {
    sniffImageFormat(path);  // what is no picture is refused without loading the codec
    return imageCodec().read(path, limits);
}

ImageMetadata readImageMetadata(const fs::path& path) {
    sniffImageFormat(path);
    return imageCodec().readMetadata(path);
}

}  // namespace chiaro
