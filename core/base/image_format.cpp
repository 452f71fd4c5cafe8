#include "core/base/image_format.h"

#include "core/base/error.h"
#include "core/base/image_io.h"

#include <array>
#include <cctype>
#include <fstream>
#include <optional>
#include <utility>

namespace chiaro {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

namespace {

std::string lowerCaseExtension(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

std::optional<ImageFormat> formatOfExtension(const fs::path& path) {
    static constexpr std::pair<std::string_view, ImageFormat> extensions[] = {
        {".png", ImageFormat::Png},  {".jpg", ImageFormat::Jpeg},  {".jpeg", ImageFormat::Jpeg},
        {".tif", ImageFormat::Tiff}, {".tiff", ImageFormat::Tiff}, {".exr", ImageFormat::OpenExr}};
    const std::string extension = lowerCaseExtension(path);
    for (const auto& [name, format] : extensions)
        if (extension == name) return format;
    return std::nullopt;
}

std::optional<ImageFormat> formatOfMagic(std::string_view magic) {
    static constexpr std::pair<std::string_view, ImageFormat> magics[] = {
        {"\x89PNG\r\n\x1a\n"sv, ImageFormat::Png},
        {"\xFF\xD8\xFF"sv, ImageFormat::Jpeg},
        {"II*\0"sv, ImageFormat::Tiff},
        {"MM\0*"sv, ImageFormat::Tiff},
        {"II+\0"sv, ImageFormat::Tiff},
        {"MM\0+"sv, ImageFormat::Tiff},
        {"\x76\x2f\x31\x01"sv, ImageFormat::OpenExr}};
    for (const auto& [bytes, format] : magics)
        if (magic.starts_with(bytes)) return format;
    if (magic.starts_with("RIFF") && magic.substr(std::min<std::size_t>(8, magic.size())).starts_with("WEBP"))
        return ImageFormat::WebP;
    return std::nullopt;
}

}  // namespace

const char* codecName(ImageFormat format) {
    return std::array{"png", "jpeg", "tiff", "openexr", "webp"}[std::size_t(format)];
}

const char* displayName(ImageFormat format) {
    return std::array{"PNG", "JPEG", "TIFF", "OpenEXR", "WebP"}[std::size_t(format)];
}

ImageFormat sniffImageFormat(const fs::path& path) {
    std::error_code error;
    if (!fs::exists(path, error)) throw Error(path.string(), "no such file", "check the name and the folder");
    if (!fs::is_regular_file(path, error)) throw Error(path.string(), "is not a file", "name a picture file");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw Error(path.string(), "can't be opened", "check that you may read it");
    std::string magic(12, '\0');
    stream.read(magic.data(), std::streamsize(magic.size()));
    magic.resize(std::size_t(stream.gcount()));
    if (magic.empty()) throw Error(path.string(), "the file is empty", "save or copy the picture again");
    const std::optional<ImageFormat> format = formatOfMagic(magic);
    if (!format)
        throw Error(path.string(), "is not a picture that can be read",
                    "give a PNG, JPEG, TIFF, OpenEXR or WebP file");
    return *format;
}

ImageFormat writableFormat(const fs::path& path) {
    const std::optional<ImageFormat> format = formatOfExtension(path);
    if (!format)
        throw Error(path.string(),
                    "pictures are not written with the extension \"" + path.extension().string() + "\"",
                    "use .png, .tif, .jpg or .exr");
    return *format;
}

bool isWritableImage(const fs::path& path) {
    return formatOfExtension(path).has_value();
}

}  // namespace chiaro
