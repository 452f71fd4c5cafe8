#include "app/cli/data_pictures.h"

#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>

namespace chiaro::cli {

ScalarImage readLight(const std::filesystem::path& path) {
    ImageLimits limits;
    limits.mayBeNotFinite = true;
    const DecodedImage image = readImage(path, limits);
    ScalarImage light(image.width, image.height);
    const auto channels = std::size_t(image.channels);
    for (std::size_t i = 0; i < light.pixelCount(); ++i) {
        const float* const pixel = image.values.data() + i * channels;
        float& value = light.pixels()[i];
        value = channels < 3 ? pixel[0] : 0.2126f * pixel[0] + 0.7152f * pixel[1] + 0.0722f * pixel[2];
        if (channels % 2 == 0 && !(pixel[channels - 1] >= 0.5f)) value = -1;
    }
    return light;
}

IdImage readIds(const std::filesystem::path& path) {
    const DecodedImage image = readImage(path);
    if (image.channels > 2)
        throw Error(path.string(), "has colours",
                    "save the ids as 8 or 16-bit grey: 0 outside, 1.. the object");
    IdImage ids(image.width, image.height);
    const auto channels = std::size_t(image.channels);
    const double scale = image.bits > 0 ? std::exp2(image.bits) - 1 : 1;
    for (std::size_t i = 0; i < ids.pixelCount(); ++i) {
        const double id = std::round(double(image.values[i * channels]) * scale);
        if (!(id >= 0 && id <= greatestId))
            throw Error(path.string(), fmt::format("has the id {:g}", id), "ids are 0..65535");
        ids.pixels()[i] = std::uint16_t(id);
    }
    return ids;
}

}  // namespace chiaro::cli
