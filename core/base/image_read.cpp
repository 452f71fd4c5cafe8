#include "core/base/codec/codec.h"
#include "core/base/image_format.h"
#include "core/base/image_import.h"
#include "core/base/image_io.h"
#include "core/base/import.h"

namespace chiaro {

namespace fs = std::filesystem;

DecodedImage readImage(const fs::path& path, const ImageLimits& limits) {
    sniffImageFormat(path);  // what is no picture is refused without loading the codec
    if (auto* helpers = importHelpers()) return importImage(*helpers, path, limits, {});
    std::vector<std::byte> values;
    const StoredImage stored = imageCodec().read(path, limits, [&](std::size_t size) {
        values.resize(size);
        return static_cast<void*>(values.data());
    });
    return decodedFrom(stored, values, path, limits);
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
    if (auto* helpers = importHelpers()) return importImageMetadata(*helpers, path, {});
    return imageCodec().readMetadata(path);
}

}  // namespace chiaro
