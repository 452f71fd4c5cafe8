#include "core/base/codec/codec.h"
#include "core/base/image_format.h"
#include "core/base/image_io.h"

namespace chiaro {

namespace fs = std::filesystem;

DecodedImage readImage(const fs::path& path, const ImageLimits& limits) {
    sniffImageFormat(path);  // what is no picture is refused without loading the codec
    return imageCodec().read(path, limits);
}

Image<glm::vec2> readVectors(const fs::path& path, ImageLimits limits) {
    limits.asVectors = true;
    limits.mayBeNotFinite = true;
    const DecodedImage image = readImage(path, limits);
    Image<glm::vec2> vectors(image.width, image.height);
    for (std::size_t i = 0; i < vectors.pixelCount(); ++i)
        vectors.pixels()[i] = {image.values[2 * i], image.values[2 * i + 1]};
    return vectors;
}

ImageMetadata readImageMetadata(const fs::path& path) {
    sniffImageFormat(path);
    return imageCodec().readMetadata(path);
}

}  // namespace chiaro
