#include "app/file_kind.h"

#include "core/base/error.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace chiaro::app {

namespace {

struct Mark {
    std::string_view bytes;
    FileKind kind;
};

using namespace std::string_view_literals;

constexpr Mark marks[] = {
    {"\x89PNG"sv, FileKind::Strip},
    {"\xFF\xD8\xFF"sv, FileKind::Strip},
    {"II*\0"sv, FileKind::Strip},
    {"MM\0*"sv, FileKind::Strip},
    {"II+\0"sv, FileKind::Strip},
    {"MM\0+"sv, FileKind::Strip},
    {"\x76\x2F\x31\x01"sv, FileKind::Strip},
    {"RIFF"sv, FileKind::Strip},
    {"ply\n"sv, FileKind::Mesh},
    {"ply\r"sv, FileKind::Mesh},
    {"glTF"sv, FileKind::Mesh},
    {"OFF"sv, FileKind::Mesh},
};

constexpr std::pair<std::string_view, FileKind> extensions[] = {
    {".chiaro", FileKind::Project}, {".png", FileKind::Strip},  {".tif", FileKind::Strip},
    {".tiff", FileKind::Strip},     {".jpg", FileKind::Strip},  {".jpeg", FileKind::Strip},
    {".exr", FileKind::Strip},      {".webp", FileKind::Strip}, {".obj", FileKind::Mesh},
    {".ply", FileKind::Mesh},       {".off", FileKind::Mesh},   {".stl", FileKind::Mesh},
    {".glb", FileKind::Mesh},       {".gltf", FileKind::Mesh},
};

}  // namespace

FileKind fileKind(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string start(16, '\0');
    file.read(start.data(), std::streamsize(start.size()));
    if (!file.is_open() || file.bad() || !std::filesystem::is_regular_file(path))
        throw Error(path.string(), "can't be read", "open a strip, a mesh or a project that is there");
    start.resize(std::size_t(file.gcount()));
    for (const Mark& mark : marks)
        if (start.starts_with(mark.bytes)) return mark.kind;

    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return char(std::tolower(letter)); });
    for (const auto& [known, kind] : extensions)
        if (extension == known) return kind;
    throw Error(
        path.string(), "is no file that Chiaro knows",
        "open a strip (PNG, TIFF, JPEG, EXR, WebP), a mesh (OBJ, PLY, OFF, STL, GLB, glTF) or a project "
        "(.chiaro)");
}

}  // namespace chiaro::app
