#pragma once

#include "core/base/image.h"

#include <filesystem>
#include <map>
#include <string>

namespace chiaro {

/// A decoded picture: 1..4 channels of float a pixel, interleaved, upright (EXIF orientation applied).
struct DecodedImage {
    int width = 0;
    int height = 0;
    int channels = 0;           ///< 1 grey, 2 grey + alpha, 3 RGB, 4 RGB + alpha
    bool linear = false;        ///< the values are scene-linear (EXR), else display-referred in [0, 1]
    std::vector<float> values;  ///< width * height * channels, row after row; alpha is not premultiplied
    int bits = 0;  ///< of a stored integer, which was (2^bits - 1) times the value; 0 when floats are stored
};

/// What a picture may be before a pixel of it is decoded.
struct ImageLimits {
    int maximumSide = 32768;                    ///< pixels
    std::uint64_t maximumPixels = 100'000'000;  ///< pixels; reading takes up to 32 bytes for each
    bool mayBeNotFinite = false;                ///< take NaN and infinities, which say "nothing here" in data
    bool asVectors = false;  ///< take two plain values a pixel, X and Y (or R and G) of an OpenEXR file
};

/// Reads PNG, JPEG, TIFF, OpenEXR or WebP; the content decides the format, not the name. The first picture of
/// an animated or layered file; of an OpenEXR file the display window. Palettes become RGB, CMYK becomes RGB.
/// Throws Error naming the file when it is missing, of another format,
/// damaged, truncated, or beyond the limits, and
/// when values aren't finite where they must be. Thread-safe; the first call takes 0.3 s longer.
DecodedImage readImage(const std::filesystem::path& path, const ImageLimits& limits = {});

/// Reads two plain values a pixel, such as a displacement, as writeImage writes them; they may be NaN or
/// infinite. Only OpenEXR. Throws what readImage throws.
Image<glm::vec2> readVectors(const std::filesystem::path& path, ImageLimits limits = {});

/// Entries written into the picture's metadata: what made it (version, command, parameters).
using ImageMetadata = std::map<std::string, std::string>;

/// What a picture's metadata says: the entries that writeImage put in, and whatever else the file tells in
/// text. Throws as readImage does.
ImageMetadata readImageMetadata(const std::filesystem::path& path);

/// Bits a channel of integer formats; EXR holds float and JPEG 8 bits whatever this says.
enum class PixelDepth { Bits8, Bits16 };

/// What the file looks like afterwards is decided by the extension: .png, .tif, .tiff, .jpg, .jpeg hold
/// display-referred values clipped to [0, 1] and rounded, halves up; .exr holds 32-bit float as given (pass
/// linear values for a picture). JPEG shows coverage over white. PNG and EXR hold each metadata entry under
/// its key, TIFF and JPEG as lines of their description. The same input gives the same bytes. Written
/// atomically. Throws Error naming the path when the extension is another one or the disk refuses.
void writeImage(const std::filesystem::path& path, const ColorImage& image,
                const ImageMetadata& metadata = {}, PixelDepth depth = PixelDepth::Bits8);
void writeImage(const std::filesystem::path& path, const ColorAlphaImage& image,
                const ImageMetadata& metadata = {}, PixelDepth depth = PixelDepth::Bits8);
void writeImage(const std::filesystem::path& path, const ScalarImage& image,
                const ImageMetadata& metadata = {}, PixelDepth depth = PixelDepth::Bits8);
/// Two values a pixel as they are, such as a displacement. Only EXR. Throws Error too when the path is
/// another.
void writeImage(const std::filesystem::path& path, const Image<glm::vec2>& image,
                const ImageMetadata& metadata = {});
/// Ids as they are, in 8 bits when all fit and 16 otherwise. PNG or TIFF.
void writeImage(const std::filesystem::path& path, const IdImage& image, const ImageMetadata& metadata = {});

/// True for a path whose extension writeImage takes.
bool isWritableImage(const std::filesystem::path& path);

}  // namespace chiaro
