#include "core/scene/text_scanner.h"

#include <optional>
#include <unordered_map>

namespace chiaro::scene {

namespace {

/// A corner of a face: indices into the file's vertices and normals; noIndex where no normal is given.
struct Corner {
    std::uint32_t vertex = 0;
    std::uint32_t normal = noIndex;
};

/// An object while it grows: corners become vertices of its own, one for each pair of vertex and normal that
/// occurs.
struct ObjectBuilder {
    Mesh mesh;
    std::vector<Corner> vertices;
};

/// OBJ: vertices and normals of the whole file, faces that belong to the object (`o`) named last or, while
/// there is none, to the group (`g`) named last. Indices count from 1, or backwards from the latest with a
/// minus. Materials, smoothing groups, texture coordinates, points, lines and curves are passed over.
class ObjReader {
public:
    explicit ObjReader(const MeshSource& source) : m_source(source), m_scanner(source, source.bytes) {}

    RawModel read() {
        countVertices();
        m_objects.emplace_back();
        while (m_scanner.nextLine()) {
            const std::string_view keyword = m_scanner.word();
            if (keyword == "v") m_positions.push_back(m_scanner.position());
            if (keyword == "vn") m_normals.push_back(m_scanner.direction());
            if (keyword == "f") readFace();
            if (keyword == "o") startObject(true);
            if (keyword == "g" && !m_objectsNamed) startObject(false);
        }
        for (ObjectBuilder& object : m_objects) finish(object);
        if (m_emptyObjects > 0)
            m_model.warnings.push_back(std::to_string(m_emptyObjects) +
                                       (m_emptyObjects == 1 ? " object without faces was left out."
                                                            : " objects without faces were left out."));
        return std::move(m_model);
    }

private:
    // Faces may name vertices that come later, so how many there are is known before the first face.
    void countVertices() {
        TextScanner scanner(m_source, m_source.bytes);
        while (scanner.nextLine()) {
            const std::string_view keyword = scanner.word();
            m_vertexCount += keyword == "v";
            m_normalCount += keyword == "vn";
        }
        checkVertexCount(m_source, m_vertexCount);
        checkVertexCount(m_source, m_normalCount);
        m_positions.reserve(m_vertexCount);
        m_normals.reserve(m_normalCount);
    }

    void startObject(bool isObject) {
        m_objectsNamed = m_objectsNamed || isObject;
        m_objects.emplace_back().mesh.name = m_scanner.rest();
        m_localVertices = {};
    }

    std::uint32_t resolve(std::string_view text, std::size_t latest, std::size_t count,
                          std::string_view what) {
        const std::optional<long long> index = TextScanner::integerOf(text);
        if (!index)
            throw m_scanner.error("\"" + std::string(text.substr(0, 40)) + "\" is no index",
                                  "faces are written as f 1 2 3 or f 1/1/1 2/2/2 3/3/3");
        const long long resolved = *index < 0 ? (long long)(latest) + *index : *index - 1;
        if (*index == 0 || resolved < 0 || resolved >= (long long)(count))
            throw m_scanner.error("the face names " + std::string(what) + " " + std::to_string(*index) +
                                      " of " + std::to_string(count),
                                  "indices go from 1 to the number of them, or backwards from -1");
        return std::uint32_t(resolved);
    }

    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    Corner parseCorner(std::string_view text) {
        const std::size_t first = text.find('/');
        const std::size_t second = first == text.npos ? text.npos : text.find('/', first + 1);
        Corner corner;
        corner.vertex = resolve(text.substr(0, first), m_positions.size(), m_vertexCount, "vertex");
        if (second != text.npos && second + 1 < text.size())
            corner.normal = resolve(text.substr(second + 1), m_normals.size(), m_normalCount, "normal");
        return corner;
    }

    void readFace() {
        ObjectBuilder& object = m_objects.back();
        m_corners.clear();
        for (std::string_view text = m_scanner.word(); !text.empty(); text = m_scanner.word())
            m_corners.push_back(localVertex(object, parseCorner(text)));
        addPolygon(m_source, m_model, object.mesh, m_corners);
    }

    std::uint32_t localVertex(ObjectBuilder& object, Corner corner) {
        const std::uint64_t key = std::uint64_t(corner.vertex) << 32 | corner.normal;
        const auto [entry, isNew] = m_localVertices.try_emplace(key, std::uint32_t(object.vertices.size()));
        if (isNew) object.vertices.push_back(corner);
        return entry->second;
    }

    // Vertices may follow the faces that name them, so positions are looked up at the end.
    void finish(ObjectBuilder& object) {
        if (object.mesh.triangles.empty()) {
            m_emptyObjects += !object.mesh.name.empty();
            return;
        }
        for (const Corner& corner : object.vertices) {
            object.mesh.positions.push_back(m_positions[corner.vertex]);
            if (m_normalCount > 0)
                object.mesh.normals.push_back(corner.normal == noIndex ? glm::vec3(0)
                                                                       : m_normals[corner.normal]);
        }
        m_model.objects.push_back(std::move(object.mesh));
    }

    const MeshSource& m_source;
    TextScanner m_scanner;
    RawModel m_model;
    std::vector<ObjectBuilder> m_objects;
    std::size_t m_emptyObjects = 0;
    bool m_objectsNamed = false;
    std::size_t m_vertexCount = 0;
    std::size_t m_normalCount = 0;
    std::vector<glm::vec3> m_positions;
    std::vector<glm::vec3> m_normals;
    std::unordered_map<std::uint64_t, std::uint32_t> m_localVertices;  ///< of the latest object
    std::vector<std::uint32_t> m_corners;
};

}  // namespace

RawModel readObj(const MeshSource& source) {
    return ObjReader(source).read();
}

}  // namespace chiaro::scene
