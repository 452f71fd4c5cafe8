#include "core/base/error.h"
#include "core/export/mesh_writers.h"
#include "core/scene/tinygltf.h"

#include <array>
#include <bit>
#include <cstring>
#include <sstream>

namespace chiaro::exporting {

namespace {

static_assert(std::endian::native == std::endian::little, "values are written as they lie in memory");

constexpr const char* unlit = "KHR_materials_unlit";

/// A file keeps turning, scaling and moving apart; a place that shears is none that it could tell.
bool isPlaceOfNode(const glm::mat4& transform) {
    const glm::dmat3 axes{glm::dmat4(transform)};
    if (!(std::abs(glm::determinant(axes)) > 0)) return false;
    for (int i = 0; i < 3; ++i)
        if (std::abs(glm::dot(glm::normalize(axes[i]), glm::normalize(axes[(i + 1) % 3]))) > 1e-5)
            return false;
    return true;
}

class GlbBuilder {
public:
    explicit GlbBuilder(const ImageMetadata& metadata) {
        const auto software = metadata.find("Software");
        m_model.asset.generator = software == metadata.end() ? "Chiaro" : software->second;
        m_model.asset.version = "2.0";
        m_model.buffers.emplace_back();
        m_model.scenes.emplace_back();
        m_model.defaultScene = 0;
    }

    void addTexture(const std::string& png, Bake bake) {
        tinygltf::Image image;
        image.name = "paint";
        image.mimeType = "image/png";
        image.bufferView = addView(png.data(), png.size(), 0);
        m_model.images.push_back(std::move(image));
        tinygltf::Sampler sampler;
        sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
        sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
        sampler.wrapS = sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
        m_model.samplers.push_back(sampler);
        tinygltf::Texture texture;
        texture.sampler = 0;
        texture.source = 0;
        m_model.textures.push_back(texture);
        if (bake == Bake::Lit) m_model.extensionsUsed.push_back(unlit);
    }

    void addObject(const TexturedObject& object) {
        const PlacedVertices placed(object);
        const bool keepsPlace = isPlaceOfNode(object.transform);
        std::vector<glm::vec3> positions = object.positions, normals = object.normals;
        std::vector<scene::Triangle> triangles = object.triangles;
        if (!keepsPlace) {
            for (glm::vec3& position : positions) position = placed.position(position);
            for (glm::vec3& normal : normals) normal = placed.normal(normal);
            for (scene::Triangle& triangle : triangles) triangle = placed.triangle(triangle);
        }
        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        if (!m_model.textures.empty()) primitive.material = material(object.isDoubleSided);
        primitive.attributes["POSITION"] = addVectors(positions, TINYGLTF_TYPE_VEC3);
        tinygltf::Accessor& accessor = m_model.accessors.back();
        glm::vec3 low = positions[0], high = low;
        for (const glm::vec3& position : positions) {
            low = glm::min(low, position);
            high = glm::max(high, position);
        }
        accessor.minValues = {double(low.x), double(low.y), double(low.z)};
        accessor.maxValues = {double(high.x), double(high.y), double(high.z)};
        primitive.attributes["NORMAL"] = addVectors(normals, TINYGLTF_TYPE_VEC3);
        if (!object.coordinates.empty())
            primitive.attributes["TEXCOORD_0"] = addVectors(object.coordinates, TINYGLTF_TYPE_VEC2);
        primitive.indices = addIndices(triangles, positions.size());
        tinygltf::Mesh mesh;
        mesh.name = object.name;
        mesh.primitives.push_back(std::move(primitive));
        tinygltf::Node node;
        node.name = object.name;
        node.mesh = int(m_model.meshes.size());
        if (keepsPlace && object.transform != glm::mat4(1))
            for (int i = 0; i < 16; ++i) node.matrix.push_back(double(object.transform[i / 4][i % 4]));
        m_model.meshes.push_back(std::move(mesh));
        m_model.scenes[0].nodes.push_back(int(m_model.nodes.size()));
        m_model.nodes.push_back(std::move(node));
    }

    std::string bytes(const std::filesystem::path& path) {
        std::ostringstream stream;
        tinygltf::TinyGLTF writer;
        // The GLB's binary chunk is part of the length that its header tells in 32 bits.
        if (m_model.buffers[0].data.size() > 0xF0000000u ||
            !writer.WriteGltfSceneToStream(&m_model, stream, false, true) || !stream)
            throw Error(path.string(), "is too large for a GLB", "choose .obj, or a simpler mesh");
        return std::move(stream).str();
    }

private:
    /// The paint, made when an object wears it first.
    int material(bool isDoubleSided) {
        int& known = m_materials[isDoubleSided];
        if (known >= 0) return known;
        tinygltf::Material material;
        material.name = isDoubleSided ? "paint" : "paint, front only";
        material.doubleSided = isDoubleSided;
        material.pbrMetallicRoughness.baseColorTexture.index = 0;
        material.pbrMetallicRoughness.metallicFactor = 0;
        material.pbrMetallicRoughness.roughnessFactor = 1;
        if (!m_model.extensionsUsed.empty())
            material.extensions[unlit] = tinygltf::Value(tinygltf::Value::Object());
        m_model.materials.push_back(std::move(material));
        return known = int(m_model.materials.size()) - 1;
    }

    int addView(const void* bytes, std::size_t size, int target) {
        std::vector<unsigned char>& data = m_model.buffers[0].data;
        data.resize((data.size() + 3) / 4 * 4);
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = data.size();
        view.byteLength = size;
        view.target = target;
        const auto* begin = static_cast<const unsigned char*>(bytes);
        data.insert(data.end(), begin, begin + size);
        m_model.bufferViews.push_back(std::move(view));
        return int(m_model.bufferViews.size()) - 1;
    }

    int addAccessor(int view, int componentType, std::size_t count, int type) {
        tinygltf::Accessor accessor;
        accessor.bufferView = view;
        accessor.componentType = componentType;
        accessor.count = count;
        accessor.type = type;
        m_model.accessors.push_back(std::move(accessor));
        return int(m_model.accessors.size()) - 1;
    }

    template <class Vector>
    int addVectors(const std::vector<Vector>& vectors, int type) {
        const int view =
            addView(vectors.data(), vectors.size() * sizeof(Vector), TINYGLTF_TARGET_ARRAY_BUFFER);
        return addAccessor(view, TINYGLTF_COMPONENT_TYPE_FLOAT, vectors.size(), type);
    }

    int addIndices(const std::vector<scene::Triangle>& triangles, std::size_t vertices) {
        const std::size_t count = triangles.size() * 3;
        if (vertices > 65535) {  // the last number that 16 bits hold means something else
            const int view = addView(triangles.data(), count * 4, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
            return addAccessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, count, TINYGLTF_TYPE_SCALAR);
        }
        std::vector<std::uint16_t> corners;
        corners.reserve(count);
        for (const scene::Triangle& triangle : triangles)
            for (const std::uint32_t vertex : triangle) corners.push_back(std::uint16_t(vertex));
        const int view = addView(corners.data(), count * 2, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        return addAccessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, count, TINYGLTF_TYPE_SCALAR);
    }

    tinygltf::Model m_model;
    std::array<int, 2> m_materials{-1, -1};
};

}  // namespace

std::string glbBytes(const std::filesystem::path& path, const TexturedScene& scene,
                     const ImageMetadata& metadata) {
    GlbBuilder builder(metadata);
    if (!scene.texture.empty()) builder.addTexture(pngBytes(path, scene.texture, metadata), scene.bake);
    for (const TexturedObject& object : scene.objects) builder.addObject(object);
    return builder.bytes(path);
}

}  // namespace chiaro::exporting
