#include "core/scene/side_files.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fstream>

namespace chiaro::scene {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largestJson = std::uintmax_t(1) << 30;
constexpr std::uintmax_t largestMaterial = 16 << 20;

class Gatherer {
public:
    explicit Gatherer(const fs::path& mesh) : m_folder(fs::absolute(mesh).parent_path()) {}

    /// True when the file is there, beside the mesh or below.
    bool add(const fs::path& named) {
        const fs::path path = named.lexically_normal();
        std::error_code ignored;
        if (path.empty() || path.is_absolute() || *path.begin() == ".." ||
            !fs::is_regular_file(m_folder / path, ignored))
            return false;
        if (std::ranges::find(m_found, path) == m_found.end()) m_found.push_back(path);
        return true;
    }
    const fs::path& folder() const { return m_folder; }
    std::vector<fs::path> found() && { return std::move(m_found); }

private:
    fs::path m_folder;
    std::vector<fs::path> m_found;
};

/// "a%20b" as "a b".
std::string decoded(const std::string& uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool isCode = uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(uri[i + 1] & 0xff) &&
                            std::isxdigit(uri[i + 2] & 0xff);
        text += isCode ? char(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
        if (isCode) i += 2;
    }
    return text;
}

/// The JSON of a glTF file, or of the first part of a GLB.
std::string gltfJson(const fs::path& mesh) {
    std::ifstream file(mesh, std::ios::binary);
    std::array<char, 20> start{};
    file.read(start.data(), std::streamsize(start.size()));
    if (!file || std::string_view(start.data(), 4) != "glTF") return readFile(mesh, largestJson);
    std::uint32_t length = 0;
    std::memcpy(&length, start.data() + 12, sizeof length);
    std::error_code error;
    if (length > fs::file_size(mesh, error) || error) return {};
    std::string json(length, '\0');
    file.read(json.data(), std::streamsize(length));
    return json;
}

void addGltf(const fs::path& mesh, Gatherer& gatherer) {
    const auto json = nlohmann::json::parse(gltfJson(mesh), nullptr, false);
    if (!json.is_object()) return;
    for (const char* list : {"buffers", "images"}) {
        const auto found = json.find(list);
        if (found == json.end() || !found->is_array()) continue;
        for (const nlohmann::json& one : *found) {
            if (!one.is_object() || !one.contains("uri") || !one["uri"].is_string()) continue;
            const auto uri = one["uri"].get<std::string>();
            if (uri.starts_with("data:")) continue;
            if (!gatherer.add(uri)) gatherer.add(decoded(uri));
        }
    }
}

/// What comes behind the first word of a line, without the spaces around it.
std::string behindFirstWord(const std::string& line, std::size_t begin) {
    const std::size_t word = std::min(line.find_first_of(" \t", begin), line.size());
    const std::size_t rest = line.find_first_not_of(" \t", word);
    if (rest == line.npos) return {};
    return line.substr(rest, line.find_last_not_of(" \t\r") + 1 - rest);
}

/// A name that may stand behind options, and may hold spaces.
void addName(const std::string& text, const fs::path& folder, Gatherer& gatherer) {
    for (std::size_t begin = 0; begin != text.npos && begin < text.size();) {
        if (gatherer.add(folder / text.substr(begin))) return;
        begin = text.find_first_not_of(" \t", std::min(text.find_first_of(" \t", begin), text.size()));
    }
}

void addMaterial(const fs::path& material, Gatherer& gatherer) {
    std::ifstream file(gatherer.folder() / material);
    std::error_code error;
    if (fs::file_size(gatherer.folder() / material, error) > largestMaterial || error) return;
    for (std::string line; std::getline(file, line);) {
        const std::size_t begin = line.find_first_not_of(" \t");
        if (begin == line.npos) continue;
        const std::string_view text = std::string_view(line).substr(begin);
        for (const char* key : {"map_", "bump", "disp", "decal", "refl", "norm"})
            if (text.starts_with(key))
                addName(behindFirstWord(line, begin), material.parent_path(), gatherer);
    }
}

void addObj(const fs::path& mesh, Gatherer& gatherer) {
    std::ifstream file(mesh);
    for (std::string line; std::getline(file, line);) {
        const std::size_t begin = line.find_first_not_of(" \t");
        if (begin == line.npos || !std::string_view(line).substr(begin).starts_with("mtllib")) continue;
        const fs::path material = behindFirstWord(line, begin);
        if (gatherer.add(material)) addMaterial(material, gatherer);
    }
}

}  // namespace

std::vector<fs::path> sideFiles(const fs::path& mesh) {
    std::string extension = mesh.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char letter) { return char(std::tolower(letter)); });
    Gatherer gatherer(mesh);
    try {
        if (extension == ".gltf" || extension == ".glb") addGltf(mesh, gatherer);
        if (extension == ".obj") addObj(mesh, gatherer);
    } catch (const Error&) {
        return {};
    }
    return std::move(gatherer).found();
}

}  // namespace chiaro::scene
