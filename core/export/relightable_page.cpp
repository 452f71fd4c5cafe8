#include "core/export/relightable_page.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/export/mesh_writers.h"
#include "core/export/page_parts.h"
#include "core/gradient/color_presets.h"
#include "core/methods/level_texels.h"
#include "core/methods/object_texels.h"
#include "core/scene/mesh_winding.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cctype>

namespace chiaro::exporting {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

/// Of the 3D textures: what browsers offer on phones too.
constexpr int largestSide = 2048;
/// Of an object's texels in graphics memory; larger maps are halved.
constexpr std::size_t textureBytes = std::size_t(192) << 20;
/// Of JPEG. Painted strokes differ by 2/255 for it; views take ten times the room that levels do.
constexpr int levelQuality = 92, viewQuality = 85;
constexpr int presetColors = 64;

std::string escaped(std::string_view text) {
    std::string html;
    for (const char c : text) switch (c) {
            case '&':
                html += "&amp;";
                break;
            case '<':
                html += "&lt;";
                break;
            case '"':
                html += "&quot;";
                break;
            default:
                html += c;
        }
    return html;
}

std::string pageProgram() {
    const fs::path file = pageFile();
    std::error_code ignored;
    if (!fs::exists(file, ignored))
        throw Error("relightable page", "was left out when Chiaro was built, for want of three.js",
                    "build again with npm and a network");
    return readFile(file, 64 << 20);
}

void replace(std::string& text, const std::string& mark, const std::string& by) {
    const std::size_t place = text.find(mark);
    if (place == std::string::npos)
        throw Error(pageFile().string(), "is not the page's program", "install Chiaro again");
    text.replace(place, mark.size(), by);
}

Json vector(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

/// Makes the scene's JSON and its parts.
class PageWriter {
public:
    PageWriter(const fs::path& path, const PageScene& scene) : m_path(path), m_scene(scene), m_parts(path) {}

    Json write(const ImageMetadata& metadata, const Task& task) {
        Json json{{"title", m_scene.title},
                  {"method", m_scene.method},
                  {"density", m_scene.viewAligned.density},
                  {"followZoom", m_scene.viewAligned.followZoom},
                  {"followCamera", m_scene.viewDependent.followCamera},
                  {"preserving", m_scene.viewDependent.blend == methods::Blend::Preserving},
                  {"camera", camera()},
                  {"lights", Json::array()},
                  {"presets", Json::array()},
                  {"paints", Json::array()}};
        for (const scene::Light& light : m_scene.lights)
            if (light.visible) json["lights"].push_back(lightJson(light));
        for (const gradient::ColorPreset& preset : gradient::colorPresets())
            json["presets"].push_back({{"name", preset.name}, {"colors", hexColors(preset.path)}});
        json["mesh"] = mesh(metadata);
        const double share = 1 / double(m_scene.paints.size() + m_scene.objects.size());
        double done = 0;
        const auto next = [&] { return task.part(share * std::exchange(done, done + 1), share * done); };
        for (const PagePaint& paint : m_scene.paints) json["paints"].push_back(paintJson(paint, next()));
        objects(json, next);
        return json;
    }

    const PageParts& parts() const { return m_parts; }

private:
    Json camera() const {
        const scene::Camera& camera = m_scene.camera;
        return {{"azimuth", camera.azimuth},   {"elevation", camera.elevation},
                {"distance", camera.distance}, {"target", vector(camera.target)},
                {"radius", camera.radius},     {"fieldOfView", camera.fieldOfView}};
    }

    static Json lightJson(const scene::Light& light) {
        return {{"kind", light.kind == scene::Light::Kind::Point ? "point" : "directional"},
                {"vector", vector(light.vector)},
                {"intensity", light.intensity},
                {"wrap", light.wrap}};
    }

    static std::string hexColors(const gradient::ColorPath& path) {
        std::string hex;
        for (const glm::vec3& color : path.sampled(presetColors)) {
            const glm::ivec3 bytes(color * 255.0f + 0.5f);
            hex += fmt::format("{:02x}{:02x}{:02x}", bytes.r, bytes.g, bytes.b);
        }
        return hex;
    }

    std::size_t mesh(const ImageMetadata& metadata) {
        TexturedScene scene;
        for (const PageObject& object : m_scene.objects) {
            TexturedObject& one = scene.objects.emplace_back();
            one.name = object.name;
            one.transform = object.transform;
            one.positions = object.mesh->positions;
            one.normals = object.mesh->normals;
            one.triangles = scene::trianglesTowardsNormals(*object.mesh);
        }
        return m_parts.add(glbBytes(m_path, scene, metadata));
    }

    Json paintJson(const PagePaint& paint, const Task& task) {
        std::vector<std::uint16_t> colors;
        for (const glm::vec3& color : *paint.shown)
            for (int i = 0; i < 3; ++i) colors.push_back(std::uint16_t(std::lround(color[i] * 65535)));
        static const synthesis::LevelStack bare{{ColorImage(1, 1)}, {}};
        const methods::LevelTexels texels =
            methods::levelTexels(paint.levels->levels.empty() ? bare : *paint.levels);
        return {
            {"gradient", m_parts.add(colors)},
            {"levels",
             {{"size", texels.size},
              {"factor", texels.range.factor},
              {"bias", texels.range.bias},
              {"images", m_parts.addPictures(texels.texels, texels.size, texels.size, levelQuality, task)}}}};
    }

    template <class Next>
    void objects(Json& json, const Next& next) {
        json["objects"] = Json::array();
        json["textures"] = Json::array();
        std::vector<const methods::PaintedObject*> written;
        for (const PageObject& object : m_scene.objects) {
            const Task task = next();
            auto known = std::ranges::find(written, object.painted.get());
            Json textures;
            if (object.painted && known == written.end()) {
                const methods::ObjectTexels texels =
                    methods::objectTexels(*object.painted, largestSide, textureBytes);
                if (texels.layout.levelCount > 0) {
                    json["textures"].push_back(texturesJson(texels, *object.mesh, task));
                    written.push_back(object.painted.get());
                    known = written.end() - 1;
                }
            }
            if (known != written.end()) textures = known - written.begin();
            json["objects"].push_back({{"paint", object.paint}, {"textures", textures}});
        }
    }

    Json texturesJson(const methods::ObjectTexels& texels, const scene::Mesh& mesh, const Task& task) {
        const methods::ObjectTexels::Layout& layout = texels.layout;
        std::vector<float> views;
        for (const glm::vec4& row : texels.views)
            for (int i = 0; i < 4; ++i) views.push_back(row[i]);
        return {
            {"middle", vector(glm::vec3(layout.middle))},
            {"width", layout.size.x},
            {"height", layout.size.y},
            {"levelCount", layout.levelCount},
            {"pageCount", layout.pageCount},
            {"factor", layout.range.factor},
            {"bias", layout.range.bias},
            {"perspective", layout.isPerspective},
            {"views", views},
            {"faceCount", texels.faceViews.size()},
            {"faces", m_parts.add(faceBytes(texels, mesh))},
            {"images", m_parts.addPictures(texels.texels, layout.size.x, layout.size.y, viewQuality, task)}};
    }

    /// How many views each face has, in 16 bits; the view of each entry, in 16; and its weights at the face's
    /// three corners, in 8: one after the other, as such bytes shrink best.
    static std::vector<std::uint8_t> faceBytes(const methods::ObjectTexels& texels, const scene::Mesh& mesh) {
        const std::vector<scene::Triangle> turned = scene::trianglesTowardsNormals(mesh);
        std::vector<std::uint8_t> bytes;
        const auto add16 = [&bytes](std::uint32_t value) {
            bytes.push_back(std::uint8_t(value & 255));
            bytes.push_back(std::uint8_t(value >> 8 & 255));
        };
        for (const glm::uvec2& face : texels.faceViews) add16(face.y);
        for (const glm::u16vec4& entry : texels.weights) add16(entry.x);
        for (int corner = 0; corner < 3; ++corner)
            for (std::size_t face = 0; face < texels.faceViews.size(); ++face) {
                const bool isTurned = turned[face] != mesh.triangles[face];
                const int k = 1 + (isTurned && corner > 0 ? 3 - corner : corner);
                const glm::uvec2 range = texels.faceViews[face];
                for (std::uint32_t i = range.x; i < range.x + range.y; ++i)
                    bytes.push_back(std::uint8_t(std::max(1, (texels.weights[i][k] + 128) / 257)));
            }
        return bytes;
    }

    const fs::path& m_path;
    const PageScene& m_scene;
    PageParts m_parts;
};

}  // namespace

bool isPage(const fs::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return extension == ".html" || extension == ".htm";
}

void checkPageProgram() {
    pageProgram();
}

std::string pageBytes(const fs::path& path, const PageScene& scene, const ImageMetadata& metadata,
                      const Task& task) {
    std::string page = pageProgram();
    PageWriter writer(path, scene);
    const Json json = writer.write(metadata, task);
    std::string head = fmt::format("<title>{}</title>\n", escaped(scene.title));
    for (const auto& [key, value] : metadata)
        head += fmt::format("<meta name=\"{}\" content=\"{}\">\n",
                            key == "Software" ? "generator" : escaped(key), escaped(value));
    // A "<" in a name must not end the element that holds the JSON.
    std::string text = json.dump(-1, ' ', true);
    for (std::size_t place = 0; (place = text.find('<', place)) != std::string::npos;)
        text.replace(place, 1, "\\u003c");
    replace(page, "<!-- chiaro:head -->\n", head);
    replace(page, "<!-- chiaro:scene -->\n",
            "<script type=\"application/json\" id=\"scene\">" + text + "</script>\n" + writer.parts().html());
    return page;
}

}  // namespace chiaro::exporting
