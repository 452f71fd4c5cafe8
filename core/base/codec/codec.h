#pragma once

#include "core/base/image_format.h"
#include "core/base/stored_image.h"

#include <string>

namespace chiaro {

/// A picture as it is to be stored: values of one type, interleaved, row after row.
struct EncodeRequest {
    enum class Values { Bits8, Bits16, Float };
    std::filesystem::path path;  ///< only named in errors
    ImageFormat format = ImageFormat::Png;
    int width = 0;
    int height = 0;
    int channels = 0;
    Values type = Values::Bits8;
    const void* values = nullptr;
    ImageMetadata metadata;
    int quality = 95;  ///< of JPEG, 1..100
};

/// What decodes and encodes picture files. It stands in a module of its own that is loaded when the first
/// picture is read or written, since the image library brings 260 shared libraries: half a second and 100 MB
/// that no start should wait for.
struct ImageCodec {
    /// The values are decoded into what `allocate` gives.
    StoredImage (*read)(const std::filesystem::path& path, const ImageLimits& limits,
                        const AllocateValues& allocate);
    ImageMetadata (*readMetadata)(const std::filesystem::path& path);
    std::string (*encode)(const EncodeRequest& request);  ///< the file's bytes
};

/// The codec, loaded on the first call. Thread-safe. Throws Error when the module is missing.
const ImageCodec& imageCodec();

}  // namespace chiaro

/// The module's only entry.
extern "C" const chiaro::ImageCodec* chiaroImageCodec();
