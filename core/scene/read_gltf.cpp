#include "core/base/atomic_file.h"
#include "core/base/json_shape.h"
#include "core/scene/byte_reader.h"
#include "core/scene/mesh_readers.h"
#include "core/scene/tinygltf.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <optional>

namespace chiaro::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t maximumBufferFile = std::uintmax_t(1) << 31;
constexpr std::size_t maximumZeros =
    1'000'000;  // elements of all accessors that no byte of the file stands for
constexpr std::size_t maximumValues = 1'000'000;

/// What tinygltf may reach of the disk: buffers beside the file or below, by relative names.
struct Files {
    fs::path folder;
    std::string problem;  ///< the first one, for the message

    // tinygltf asks with the name put behind its base folder, which we leave empty: what arrives is the URI.
    bool allows(const std::string& uri) {
        const fs::path path = fs::path(std::u8string(uri.begin(), uri.end())).lexically_normal();
        const bool inside = path.is_relative() && !path.empty() && *path.begin() != "..";
        if (!inside && problem.empty())
            problem = "names a file outside its folder (" + uri.substr(0, 80) + ")";
        return inside;
    }

    static bool exists(const std::string& uri, void* files) {
        auto& self = *static_cast<Files*>(files);
        std::error_code ignored;
        return self.allows(uri) && fs::is_regular_file(self.folder / fs::path(uri), ignored);
    }
    static std::string expand(const std::string& uri, void*) { return uri; }
    static bool read(std::vector<unsigned char>* out, std::string* problem, const std::string& uri,
                     void* files) {
        auto& self = *static_cast<Files*>(files);
        if (!self.allows(uri)) return false;
        try {
            const std::string bytes = readFile(self.folder / fs::path(uri), maximumBufferFile);
            out->assign(bytes.begin(), bytes.end());
        } catch (const Error& error) {
            *problem += error.what();
            return false;
        }
        return true;
    }
    static bool refuseToWrite(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
        return false;
    }
};

bool passOverImage(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
                   void*) {
    return true;
}

/// The first line of a library's complaint, without the code in brackets it may begin with.
std::string firstLine(std::string text) {
    if (text.starts_with('[') && text.find("] ") != text.npos) text.erase(0, text.find("] ") + 2);
    const std::size_t begin = std::min(text.find_first_not_of(" \r\n"), text.size());
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), begin + 200);
    return text.substr(begin, end - begin);
}

/// The JSON of a glTF, or of a GLB, whose first chunk it is.
std::string_view jsonIn(const MeshSource& source) {
    if (!source.bytes.starts_with("glTF")) return source.bytes;
    if (source.bytes.size() < 20) return {};
    return source.bytes.substr(20, valueAt<std::uint32_t>(source.bytes, 12));
}

/// tinygltf calls itself for each level, and needs some hundred bytes for each value.
void checkShape(const MeshSource& source) {
    const JsonShape shape = jsonShape(jsonIn(source));
    if (shape.depth > JsonShape::deepest)
        throw source.error(
            "nests lists and objects more than " + std::to_string(JsonShape::deepest) + " deep",
            "a valid glTF 2.0 would be read");
    if (shape.values > maximumValues)
        throw source.error("describes itself with " + std::to_string(shape.values) + " values",
                           "at most " + std::to_string(maximumValues) + " are read");
}

tinygltf::Model parse(const MeshSource& source) {
    checkShape(source);
    Files files{source.path.parent_path(), {}};
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(passOverImage, nullptr);
    loader.SetFsCallbacks({Files::exists, Files::expand, Files::read, Files::refuseToWrite, &files});
    tinygltf::Model model;
    std::string problem;
    std::string warning;
    const auto size = static_cast<unsigned int>(source.bytes.size());
    bool loaded = false;
    try {
        loaded = source.bytes.starts_with("glTF")
                     ? loader.LoadBinaryFromMemory(
                           &model, &problem, &warning,
                           reinterpret_cast<const unsigned char*>(source.bytes.data()), size)
                     : loader.LoadASCIIFromString(&model, &problem, &warning, source.bytes.data(), size, "");
    } catch (const std::exception& exception) {
        problem = exception.what();
    }
    if (!files.problem.empty()) throw source.error(files.problem, "buffers must lie beside the file");
    if (!loaded)
        throw source.error("is damaged (" + firstLine(problem) + ")", "a valid glTF 2.0 would be read");
    return model;
}

/// The numbers an accessor stands for, every one of them known to lie inside its buffer.
struct AccessorView {
    std::string_view bytes;  ///< from its first element on; empty when all are zero
    std::size_t count = 0;
    std::size_t stride = 0;
    int componentType = 0;
    int components = 0;
    bool normalized = false;
};

class GltfReader {
public:
    explicit GltfReader(const MeshSource& source) : m_source(source), m_gltf(parse(source)) {}

    RawModel read() {
        for (const std::string& extension : m_gltf.extensionsRequired)
            if (extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression")
                throw m_source.error("is compressed (" + extension + ")", "export it without compression");
        checkTotals();
        m_visited.assign(m_gltf.nodes.size(), false);
        for (const int root : rootNodes()) readTree(root);
        return std::move(m_model);
    }

private:
    [[noreturn]] void damaged(const std::string& what) const {
        throw m_source.error("is damaged (" + what + ")", "a valid glTF 2.0 would be read");
    }

    template <class T>
    const T& at(const std::vector<T>& list, int index, const char* what) const {
        if (index < 0 || std::size_t(index) >= list.size())
            damaged(std::string("names ") + what + " " + std::to_string(index) + " of " +
                    std::to_string(list.size()));
        return list[std::size_t(index)];
    }

    /// A mesh may be used by many nodes and an accessor by many meshes: what all of them ask for is refused
    /// before anything is made of it.
    void checkTotals() const {
        constexpr std::size_t countless = std::size_t(1) << 40;
        struct Totals {
            std::size_t vertices = 0, triangles = 0, zeros = 0;
        };
        std::vector<Totals> meshes;
        for (const tinygltf::Mesh& mesh : m_gltf.meshes) {
            Totals& totals = meshes.emplace_back();
            for (const tinygltf::Primitive& primitive : mesh.primitives) {
                const auto position = primitive.attributes.find("POSITION");
                if (position == primitive.attributes.end()) continue;
                const auto& positions = at(m_gltf.accessors, position->second, "accessor");
                const std::size_t count = std::min(positions.count, countless);
                totals.vertices += count;
                if (positions.bufferView < 0) totals.zeros += count;
                const std::size_t corners =
                    primitive.indices < 0
                        ? count
                        : std::min(at(m_gltf.accessors, primitive.indices, "accessor").count, countless);
                const bool isList = primitive.mode < 0 || primitive.mode == TINYGLTF_MODE_TRIANGLES;
                totals.triangles += isList ? corners / 3 : corners - std::min<std::size_t>(corners, 2);
            }
        }
        Totals all;
        for (const tinygltf::Node& node : m_gltf.nodes) {
            if (node.mesh < 0) continue;
            const Totals& totals = at(meshes, node.mesh, "mesh");
            all.vertices += totals.vertices;
            all.triangles += totals.triangles;
            all.zeros += totals.zeros;
            checkVertexCount(m_source, all.vertices);
            checkTriangleCount(m_source, all.triangles);
            if (all.zeros > maximumZeros) damaged("accessors without data");
        }
    }

    /// The nodes of the scene to show; without scenes, those that are nobody's child.
    std::vector<int> rootNodes() const {
        if (!m_gltf.scenes.empty()) return at(m_gltf.scenes, std::max(m_gltf.defaultScene, 0), "scene").nodes;
        std::vector<bool> isChild(m_gltf.nodes.size(), false);
        for (const tinygltf::Node& node : m_gltf.nodes)
            for (const int child : node.children) {
                at(m_gltf.nodes, child, "node");
                isChild[std::size_t(child)] = true;
            }
        std::vector<int> roots;
        for (std::size_t i = 0; i < isChild.size(); ++i)
            if (!isChild[i]) roots.push_back(int(i));
        return roots;
    }

    // A stack instead of recursion: a hostile file may nest its nodes as deep as it likes.
    void readTree(int root) {
        std::vector<std::pair<int, glm::dmat4>> open{{root, glm::dmat4(1)}};
        while (!open.empty()) {
            const auto [index, parent] = open.back();
            open.pop_back();
            const tinygltf::Node& node = at(m_gltf.nodes, index, "node");
            if (m_visited[std::size_t(index)]) damaged("node " + std::to_string(index) + " has two parents");
            m_visited[std::size_t(index)] = true;
            const glm::dmat4 transform = parent * localTransform(node);
            if (node.mesh >= 0) readMesh(node, transform);
            for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
                open.emplace_back(*child, transform);
        }
    }

    static glm::dmat4 localTransform(const tinygltf::Node& node) {
        if (node.matrix.size() == 16) return glm::make_mat4(node.matrix.data());
        glm::dmat4 transform(1);
        if (node.translation.size() == 3)
            transform[3] = glm::dvec4(glm::make_vec3(node.translation.data()), 1);
        if (node.rotation.size() == 4)
            transform *= glm::mat4_cast(
                glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
        if (node.scale.size() == 3)
            for (int k = 0; k < 3; ++k) transform[k] *= node.scale[std::size_t(k)];
        return transform;
    }

    /// One object a node: all primitives of its mesh.
    void readMesh(const tinygltf::Node& node, const glm::dmat4& transform) {
        const tinygltf::Mesh& gltfMesh = at(m_gltf.meshes, node.mesh, "mesh");
        Mesh mesh;
        mesh.name = node.name.empty() ? gltfMesh.name : node.name;
        for (const tinygltf::Primitive& primitive : gltfMesh.primitives) {
            m_source.task.checkpoint();
            readPrimitive(primitive, transform, mesh);
        }
        if (!mesh.triangles.empty()) m_model.objects.push_back(std::move(mesh));
    }

    void readPrimitive(const tinygltf::Primitive& primitive, const glm::dmat4& transform, Mesh& mesh) {
        const auto position = primitive.attributes.find("POSITION");
        const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
        if (position == primitive.attributes.end() || mode < TINYGLTF_MODE_TRIANGLES) return;
        if (mode > TINYGLTF_MODE_TRIANGLE_FAN) damaged("unknown primitive mode " + std::to_string(mode));

        const std::size_t base = mesh.positions.size();
        const std::vector<glm::dvec3> positions = vectors(position->second);
        checkVertexCount(m_source, m_vertices += positions.size());
        for (const glm::dvec3& point : positions)
            mesh.positions.emplace_back(transform * glm::dvec4(point, 1));
        mesh.normals.resize(mesh.positions.size(), glm::vec3(0));
        const auto normal = primitive.attributes.find("NORMAL");
        if (normal != primitive.attributes.end()) {
            const std::vector<glm::dvec3> normals = vectors(normal->second);
            if (normals.size() != positions.size()) damaged("positions and normals differ in number");
            const glm::dmat3 toWorld = glm::transpose(glm::inverse(glm::dmat3(transform)));
            for (std::size_t i = 0; i < normals.size(); ++i) {
                const glm::dvec3 turned = toWorld * normals[i];
                mesh.normals[base + i] = glm::vec3(turned / std::max(glm::length(turned), 1e-300));
            }
        }
        std::vector<std::uint32_t> corners = indices(primitive.indices, positions.size());
        for (std::uint32_t& corner : corners) corner += std::uint32_t(base);
        // A transform that mirrors turns every triangle around.
        addTriangles(corners, mode, glm::determinant(glm::dmat3(transform)) < 0, mesh);
    }

    void addTriangles(const std::vector<std::uint32_t>& corners, int mode, bool mirrored, Mesh& mesh) {
        const std::size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
        for (std::size_t k = 2; k < corners.size(); k += step) {
            std::vector<std::uint32_t> triangle{corners[k - 2], corners[k - 1], corners[k]};
            if (mode == TINYGLTF_MODE_TRIANGLE_FAN) triangle = {corners[0], corners[k - 1], corners[k]};
            const bool odd = mode == TINYGLTF_MODE_TRIANGLE_STRIP && k % 2 == 1;
            if (odd != mirrored) std::swap(triangle[1], triangle[2]);
            addPolygon(m_source, m_model, mesh, triangle);
        }
    }

    AccessorView view(const tinygltf::Accessor& accessor, std::size_t viewOffset, int bufferView) const {
        AccessorView view;
        view.count = accessor.count;
        view.componentType = accessor.componentType;
        view.components = tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type));
        view.normalized = accessor.normalized;
        const int componentSize = tinygltf::GetComponentSizeInBytes(std::uint32_t(accessor.componentType));
        if (componentSize <= 0 || view.components <= 0) damaged("an accessor of unknown type");
        if (bufferView < 0 && view.count > maximumZeros) damaged("an accessor without data");
        if (bufferView < 0 || view.count == 0) return view;
        const tinygltf::BufferView& slice = at(m_gltf.bufferViews, bufferView, "buffer view");
        const std::vector<unsigned char>& buffer = at(m_gltf.buffers, slice.buffer, "buffer").data;
        if (slice.byteOffset > buffer.size() || slice.byteLength > buffer.size() - slice.byteOffset)
            damaged("a buffer view leaves its buffer");
        const std::size_t elementSize = std::size_t(componentSize) * std::size_t(view.components);
        view.stride = slice.byteStride == 0 ? elementSize : slice.byteStride;
        const std::size_t room = slice.byteLength - std::min(viewOffset, slice.byteLength);
        if (view.stride > 1024 || view.stride < elementSize || room < elementSize ||
            view.count - 1 > (room - elementSize) / view.stride)
            damaged("an accessor leaves its buffer view");
        view.bytes = std::string_view(reinterpret_cast<const char*>(buffer.data()), buffer.size())
                         .substr(slice.byteOffset + viewOffset, room);
        return view;
    }

    static double component(const AccessorView& view, std::size_t element, int k) {
        if (view.bytes.empty()) return 0;
        const std::size_t size =
            std::size_t(tinygltf::GetComponentSizeInBytes(std::uint32_t(view.componentType)));
        const std::size_t at = element * view.stride + std::size_t(k) * size;
        const auto scaled = [&](double value, double largest) {
            return view.normalized ? std::max(value / largest, -1.0) : value;
        };
        switch (view.componentType) {
            case TINYGLTF_COMPONENT_TYPE_BYTE:
                return scaled(valueAt<std::int8_t>(view.bytes, at), 127);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
                return scaled(valueAt<std::uint8_t>(view.bytes, at), 255);
            case TINYGLTF_COMPONENT_TYPE_SHORT:
                return scaled(valueAt<std::int16_t>(view.bytes, at), 32767);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
                return scaled(valueAt<std::uint16_t>(view.bytes, at), 65535);
            case TINYGLTF_COMPONENT_TYPE_INT:
                return valueAt<std::int32_t>(view.bytes, at);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
                return valueAt<std::uint32_t>(view.bytes, at);
            case TINYGLTF_COMPONENT_TYPE_FLOAT:
                return double(valueAt<float>(view.bytes, at));
            default:
                return valueAt<double>(view.bytes, at);
        }
    }

    std::vector<glm::dvec3> vectors(int index) const {
        const tinygltf::Accessor& accessor = at(m_gltf.accessors, index, "accessor");
        if (accessor.type != TINYGLTF_TYPE_VEC3) damaged("positions and normals must have three components");
        checkVertexCount(m_source, accessor.count);
        const AccessorView values = view(accessor, accessor.byteOffset, accessor.bufferView);
        std::vector<glm::dvec3> vectors(values.count, glm::dvec3(0));
        for (std::size_t i = 0; i < values.count; ++i)
            for (int k = 0; k < 3; ++k) vectors[i][k] = component(values, i, k);
        if (accessor.sparse.isSparse) replaceSparse(accessor, vectors);
        return vectors;
    }

    void replaceSparse(const tinygltf::Accessor& accessor, std::vector<glm::dvec3>& vectors) const {
        const auto& sparse = accessor.sparse;
        if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
            damaged("a sparse accessor with negative counts");
        tinygltf::Accessor places;
        places.componentType = sparse.indices.componentType;
        places.type = TINYGLTF_TYPE_SCALAR;
        places.count = std::size_t(sparse.count);
        tinygltf::Accessor replaced = accessor;
        replaced.count = places.count;
        if (sparse.indices.bufferView < 0 || sparse.values.bufferView < 0)
            damaged("a sparse accessor without data");
        const AccessorView indices =
            view(places, std::size_t(sparse.indices.byteOffset), sparse.indices.bufferView);
        const AccessorView values =
            view(replaced, std::size_t(sparse.values.byteOffset), sparse.values.bufferView);
        for (std::size_t i = 0; i < places.count; ++i) {
            const double place = component(indices, i, 0);
            if (!(place >= 0 && place < double(vectors.size())))
                damaged("a sparse accessor leaves its accessor");
            for (int k = 0; k < 3; ++k) vectors[std::size_t(place)][k] = component(values, i, k);
        }
    }

    std::vector<std::uint32_t> indices(int index, std::size_t vertices) const {
        std::vector<std::uint32_t> corners;
        if (index < 0) {
            for (std::size_t i = 0; i < vertices; ++i) corners.push_back(std::uint32_t(i));
            return corners;
        }
        const tinygltf::Accessor& accessor = at(m_gltf.accessors, index, "accessor");
        if (accessor.type != TINYGLTF_TYPE_SCALAR || accessor.sparse.isSparse || accessor.bufferView < 0)
            damaged("face indices must be a plain list");
        const AccessorView values = view(accessor, accessor.byteOffset, accessor.bufferView);
        corners.reserve(values.count);
        for (std::size_t i = 0; i < values.count; ++i) {
            const double corner = component(values, i, 0);
            if (!(corner >= 0 && corner < double(vertices)))
                damaged("a face names vertex " + wholeNumberText(corner) + " of " + std::to_string(vertices));
            corners.push_back(std::uint32_t(corner));
        }
        return corners;
    }

    const MeshSource& m_source;
    const tinygltf::Model m_gltf;
    RawModel m_model;
    std::vector<bool> m_visited;
    std::size_t m_vertices = 0;  ///< of all objects
};

}  // namespace

RawModel readGltf(const MeshSource& source) {
    return GltfReader(source).read();
}

}  // namespace chiaro::scene
