#include "tests/core/export/glb_reader.h"

#include "core/base/atomic_file.h"
#include "core/base/image_io.h"
#include "core/scene/tinygltf.h"
#include "tests/support/support.h"

#include <cstring>

namespace chiaro::test {

namespace {

bool keepImage(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
               void*) {
    return true;
}

template <class Value>
std::vector<Value> values(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors.at(std::size_t(index));
    const tinygltf::BufferView& view = model.bufferViews.at(std::size_t(accessor.bufferView));
    std::vector<Value> result(accessor.count);
    const unsigned char* begin = model.buffers.at(0).data.data() + view.byteOffset + accessor.byteOffset;
    std::memcpy(result.data(), begin, accessor.count * sizeof(Value));
    return result;
}

std::vector<scene::Triangle> triangles(const tinygltf::Model& model, int index) {
    std::vector<std::uint32_t> corners;
    if (model.accessors.at(std::size_t(index)).componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
        corners = values<std::uint32_t>(model, index);
    } else {
        const auto narrow = values<std::uint16_t>(model, index);
        corners.assign(narrow.begin(), narrow.end());
    }
    std::vector<scene::Triangle> result;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        result.push_back({corners[i], corners[i + 1], corners[i + 2]});
    return result;
}

ColorImage decoded(const std::string& png) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "texture.png", png);
    const DecodedImage picture = readImage(folder / "texture.png");
    EXPECT_EQ(picture.channels, 3);
    ColorImage result(picture.width, picture.height);
    std::memcpy(result.pixels().data(), picture.values.data(), picture.values.size() * sizeof(float));
    return result;
}

glm::vec3 sampled(const ColorImage& texture, glm::vec2 place) {
    const glm::vec2 texel = glm::clamp(place * glm::vec2(texture.width(), texture.height()) - 0.5f,
                                       glm::vec2(0), glm::vec2(texture.width() - 1, texture.height() - 1));
    const glm::ivec2 base(texel);
    const glm::ivec2 next = glm::min(base + 1, glm::ivec2(texture.width() - 1, texture.height() - 1));
    const glm::vec2 t = texel - glm::vec2(base);
    return glm::mix(glm::mix(texture(base.x, base.y), texture(next.x, base.y), t.x),
                    glm::mix(texture(base.x, next.y), texture(next.x, next.y), t.x), t.y);
}

}  // namespace

GlbScene readGlb(const std::filesystem::path& path) {
    const std::string bytes = readFile(path, 1 << 30);
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keepImage, nullptr);
    tinygltf::Model model;
    std::string problem, warning;
    EXPECT_TRUE(loader.LoadBinaryFromMemory(&model, &problem, &warning,
                                            reinterpret_cast<const unsigned char*>(bytes.data()),
                                            static_cast<unsigned>(bytes.size())))
        << problem;
    GlbScene result;
    result.requiredExtensions = model.extensionsRequired;
    result.isUnlit = model.materials.at(0).extensions.contains("KHR_materials_unlit");
    for (const int index : model.scenes.at(0).nodes) {
        const tinygltf::Node& node = model.nodes.at(std::size_t(index));
        const tinygltf::Primitive& primitive = model.meshes.at(std::size_t(node.mesh)).primitives.at(0);
        auto mesh = std::make_shared<scene::Mesh>();
        mesh->name = node.name;
        mesh->positions = values<glm::vec3>(model, primitive.attributes.at("POSITION"));
        mesh->normals = values<glm::vec3>(model, primitive.attributes.at("NORMAL"));
        mesh->triangles = triangles(model, primitive.indices);
        result.coordinates.push_back(values<glm::vec2>(model, primitive.attributes.at("TEXCOORD_0")));
        scene::Object object{.name = node.name, .mesh = mesh};
        for (std::size_t i = 0; i < node.matrix.size(); ++i)
            object.transform[int(i / 4)][int(i % 4)] = float(node.matrix[i]);
        result.scene.objects.push_back(object);
    }
    const tinygltf::BufferView& view = model.bufferViews.at(std::size_t(model.images.at(0).bufferView));
    result.png.assign(reinterpret_cast<const char*>(model.buffers.at(0).data.data()) + view.byteOffset,
                      view.byteLength);
    result.texture = decoded(result.png);
    return result;
}

UnlitPicture unlitPicture(const GlbScene& glb, const scene::GBuffer& view) {
    UnlitPicture picture{ColorImage(view.width, view.height), Image<std::uint8_t>(view.width, view.height)};
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            if (view.objectId(x, y) == 0) continue;
            const std::size_t object = view.objectId(x, y) - 1u;
            const auto& [a, b, c] = glb.scene.objects[object].mesh->triangles[view.faceId(x, y)];
            const glm::vec2 weights = view.barycentrics(x, y);
            const auto& places = glb.coordinates[object];
            picture.color(x, y) = sampled(glb.texture, places[a] * (1 - weights.x - weights.y) +
                                                           places[b] * weights.x + places[c] * weights.y);
            picture.covered(x, y) = 1;
        }
    return picture;
}

}  // namespace chiaro::test
