#pragma once

#include <filesystem>
#include <string>

namespace chiaro {

/// The picture file formats that are read; WebP is not written.
enum class ImageFormat { Png, Jpeg, Tiff, OpenExr, WebP };

/// What the image library calls its reader and writer: "png", "openexr".
const char* codecName(ImageFormat format);
/// What a user calls it: "PNG", "OpenEXR".
const char* displayName(ImageFormat format);

/// The format that the file's first bytes tell, whatever its name says. Throws Error naming the file when it
/// is missing, no file, empty, or of a format that is not read.
ImageFormat sniffImageFormat(const std::filesystem::path& path);

/// The format that the extension asks for. Throws Error when pictures are not written with such a one.
ImageFormat writableFormat(const std::filesystem::path& path);

}  // namespace chiaro
