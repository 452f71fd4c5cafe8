#include "core/base/codec/codec.h"
#include "core/export/mesh_writers.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace chiaro::exporting {

namespace {

/// Names as an OBJ file can hold them, on one line, without what begins a comment or goes on with the next
/// line; no two are the same.
class ObjNames {
public:
    std::string take(const std::string& name) {
        std::string plain = name;
        const auto isTrouble = [](unsigned char letter) {
            return letter < ' ' || letter == 127 || letter == '#' || letter == '\\';
        };
        std::ranges::replace_if(plain, isTrouble, '_');
        if (plain.find_first_not_of(" _") == plain.npos) plain = "object";
        // Spaces at either end are lost when the line is read.
        plain.erase(0, plain.find_first_not_of(' '));
        plain.erase(plain.find_last_not_of(' ') + 1);
        std::string free = plain;
        for (int& number = m_numbers[plain]; !m_taken.insert(free).second;)
            free = fmt::format("{} {}", plain, ++number + 1);
        return free;
    }

private:
    std::unordered_set<std::string> m_taken;
    std::unordered_map<std::string, int> m_numbers;
};

/// What made the file, as lines of comment.
std::string comments(const ImageMetadata& metadata) {
    std::string lines;
    for (const auto& [key, value] : metadata) lines += fmt::format("# {}: {}\n", key, value);
    return lines;
}

}  // namespace

std::string pngBytes(const std::filesystem::path& path, const ByteImage& picture,
                     const ImageMetadata& metadata) {
    return imageCodec().encode({path, ImageFormat::Png, picture.width(), picture.height(), 3,
                                EncodeRequest::Values::Bits8, picture.pixels().data(), metadata});
}

std::string mtlBytes(const std::filesystem::path& picture, const TexturedScene& scene,
                     const ImageMetadata& metadata) {
    // 0: the colour as it is; 1: lit, without gloss.
    return comments(metadata) +
           fmt::format("newmtl paint\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nd 1\nillum {}\nmap_Kd {}\n",
                       scene.bake == Bake::Lit ? 0 : 1, picture.string());
}

std::string objBytes(const std::filesystem::path& material, const TexturedScene& scene,
                     const ImageMetadata& metadata) {
    std::string text = comments(metadata) + fmt::format("mtllib {}\n", material.string());
    const auto end = std::back_inserter(text);
    std::size_t first = 1;
    ObjNames names;
    for (const TexturedObject& object : scene.objects) {
        const PlacedVertices placed(object);
        fmt::format_to(end, "o {}\nusemtl paint\n", names.take(object.name));
        // Nine digits give a float back to the bit.
        for (const glm::vec3& vertex : object.positions) {
            const glm::vec3 p = placed.position(vertex);
            fmt::format_to(end, "v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
        }
        for (const glm::vec2& place : object.coordinates)
            fmt::format_to(end, "vt {:.9g} {:.9g}\n", place.x, 1 - place.y);
        for (const glm::vec3& normal : object.normals) {
            const glm::vec3 n = placed.normal(normal);
            fmt::format_to(end, "vn {:.6g} {:.6g} {:.6g}\n", n.x, n.y, n.z);
        }
        for (const scene::Triangle& triangle : object.triangles) {
            const auto [a, b, c] = placed.triangle(triangle);
            fmt::format_to(end, "f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", a + first, b + first, c + first);
        }
        first += object.positions.size();
    }
    return text;
}

}  // namespace chiaro::exporting
