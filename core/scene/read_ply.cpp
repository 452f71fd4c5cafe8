#include "core/scene/byte_reader.h"
#include "core/scene/text_scanner.h"

#include <algorithm>
#include <optional>

namespace chiaro::scene {

namespace {

enum class Type { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

struct Property {
    std::string name;
    Type type = Type::Float32;
    std::optional<Type> countType;  ///< of a list
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

enum class Encoding { Ascii, LittleEndian, BigEndian };

struct Header {
    Encoding encoding = Encoding::Ascii;
    std::vector<Element> elements;
    std::string_view body;
};

std::size_t sizeOf(Type type) {
    switch (type) {
        case Type::Int8:
        case Type::UInt8:
            return 1;
        case Type::Int16:
        case Type::UInt16:
            return 2;
        case Type::Int32:
        case Type::UInt32:
        case Type::Float32:
            return 4;
        case Type::Float64:
            return 8;
    }
    return 8;
}

std::optional<Type> typeFrom(std::string_view name) {
    if (name == "char" || name == "int8") return Type::Int8;
    if (name == "uchar" || name == "uint8") return Type::UInt8;
    if (name == "short" || name == "int16") return Type::Int16;
    if (name == "ushort" || name == "uint16") return Type::UInt16;
    if (name == "int" || name == "int32") return Type::Int32;
    if (name == "uint" || name == "uint32") return Type::UInt32;
    if (name == "float" || name == "float32") return Type::Float32;
    if (name == "double" || name == "float64") return Type::Float64;
    return std::nullopt;
}

/// The lines up to `end_header`, checked against each other and against the size of the file.
class HeaderReader {
public:
    explicit HeaderReader(const MeshSource& source) : m_source(source), m_rest(source.bytes) {}

    Header read() {
        if (takeLine() != "ply") throw m_source.error("is no PLY", "a PLY begins with the line: ply");
        for (std::string_view line = takeLine(); line != "end_header"; line = takeLine()) readLine(line);
        if (!m_hasFormat) throw problem("the format is not told", "a line like: format ascii 1.0");
        m_header.body = m_rest;
        for (const Element& element : m_header.elements) checkRoom(element);
        return std::move(m_header);
    }

private:
    // Lines end in \n, \r\n or, by old Macintoshes, \r. A binary body begins right behind.
    std::string_view takeLine() {
        const std::size_t end = m_rest.substr(0, 65536).find_first_of("\r\n");
        ++m_lineNumber;
        if (end == m_rest.npos) {
            const std::string_view line = m_rest;
            m_rest = {};
            if (line == "end_header") return line;
            throw m_source.error("the header does not end", "it should end with the line: end_header");
        }
        const std::string_view line = m_rest.substr(0, end);
        m_rest.remove_prefix(end + (m_rest.substr(end, 2) == "\r\n" ? 2 : 1));
        return line.substr(0, line.find_last_not_of(" \t") + 1);
    }

    void readLine(std::string_view line) {
        TextScanner words(m_source, line, false);
        if (!words.nextLine()) return;
        const std::string_view keyword = words.word();
        if (keyword == "format") {
            readFormat(words.word());
        } else if (keyword == "element") {
            Element& element = m_header.elements.emplace_back();
            element.name = words.word();
            const std::optional<long long> count = TextScanner::integerOf(words.word());
            if (!count || *count < 0)
                throw problem("the element has no valid count", "a line like: element face 12");
            element.count = std::size_t(*count);
        } else if (keyword == "property") {
            if (m_header.elements.empty()) throw problem("a property of no element", "elements come first");
            m_header.elements.back().properties.push_back(readProperty(words));
        } else if (keyword != "comment" && keyword != "obj_info") {
            throw problem("unknown keyword \"" + std::string(keyword.substr(0, 40)) + "\"",
                          "a header holds format, element, property and comment");
        }
    }

    void readFormat(std::string_view name) {
        m_hasFormat = true;
        if (name == "ascii") {
            m_header.encoding = Encoding::Ascii;
        } else if (name == "binary_little_endian") {
            m_header.encoding = Encoding::LittleEndian;
        } else if (name == "binary_big_endian") {
            m_header.encoding = Encoding::BigEndian;
        } else {
            throw problem("unknown format", "ascii, binary_little_endian or binary_big_endian");
        }
    }

    Property readProperty(TextScanner& words) {
        const auto type = [&](std::string_view name) {
            if (const std::optional<Type> found = typeFrom(name)) return *found;
            throw problem("unknown type \"" + std::string(name.substr(0, 40)) + "\"",
                          "types are char to uint, float and double, or int8 to float64");
        };
        Property property;
        std::string_view word = words.word();
        if (word == "list") {
            property.countType = type(words.word());
            word = words.word();
        }
        property.type = type(word);
        property.name = words.word();
        return property;
    }

    // Nothing is allocated for a count before the file is known to be large enough for it.
    void checkRoom(const Element& element) const {
        std::size_t smallest = 0;
        for (const Property& property : element.properties)
            smallest +=
                m_header.encoding == Encoding::Ascii ? 1 : sizeOf(property.countType.value_or(property.type));
        if (element.properties.empty() ? element.count > 0 : element.count > m_header.body.size() / smallest)
            throw m_source.error("the header promises " + std::to_string(element.count) + " of element " +
                                     element.name + ", more than the file has room for",
                                 "a whole file would hold them all");
    }

    Error problem(std::string_view text, std::string_view remedy) const {
        return m_source.error("header line " + std::to_string(m_lineNumber) + ": " + std::string(text),
                              remedy);
    }

    const MeshSource& m_source;
    std::string_view m_rest;
    Header m_header;
    bool m_hasFormat = false;
    std::size_t m_lineNumber = 0;
};

/// The values of the body, one after the other.
class BodyReader {
public:
    BodyReader(const MeshSource& source, const Header& header)
        : m_source(source), m_header(header), m_scanner(source, header.body, false) {}

    double next(Type type) {
        if (m_header.encoding != Encoding::Ascii) return nextBinary(type);
        const std::string_view word = m_scanner.wordAnywhere();
        if (word.empty()) throw truncated();
        const double value = TextScanner::numberOf(word);
        const bool spelledNan = word.find_first_of("nN") != word.npos;
        if (std::isnan(value) && !spelledNan)
            throw m_source.error("\"" + std::string(word.substr(0, 40)) + "\" is no number",
                                 "the body of a PLY holds numbers only");
        return value;
    }

private:
    double nextBinary(Type type) {
        const std::string_view bytes = m_header.body;
        const std::size_t at = m_offset;
        if (bytes.size() - at < sizeOf(type)) throw truncated();
        m_offset += sizeOf(type);
        const std::endian order =
            m_header.encoding == Encoding::BigEndian ? std::endian::big : std::endian::little;
        switch (type) {
            case Type::Int8:
                return valueAt<std::int8_t>(bytes, at);
            case Type::UInt8:
                return valueAt<std::uint8_t>(bytes, at);
            case Type::Int16:
                return valueAt<std::int16_t>(bytes, at, order);
            case Type::UInt16:
                return valueAt<std::uint16_t>(bytes, at, order);
            case Type::Int32:
                return valueAt<std::int32_t>(bytes, at, order);
            case Type::UInt32:
                return valueAt<std::uint32_t>(bytes, at, order);
            case Type::Float32:
                return double(valueAt<float>(bytes, at, order));
            case Type::Float64:
                return valueAt<double>(bytes, at, order);
        }
        return 0;
    }

    Error truncated() const {
        return m_source.error("ends in the middle of its data",
                              "a whole file would hold all its header promises");
    }

    const MeshSource& m_source;
    const Header& m_header;
    TextScanner m_scanner;
    std::size_t m_offset = 0;
};

/// Vertices (x y z, nx ny nz), faces (vertex_indices) and triangle strips (-1 begins the next); every other
/// element and property is passed over.
class PlyReader {
public:
    explicit PlyReader(const MeshSource& source)
        : m_source(source), m_header(HeaderReader(source).read()), m_body(source, m_header) {}

    RawModel read() {
        m_model.objects.emplace_back();
        findVertices();
        for (const Element& element : m_header.elements)
            for (std::size_t i = 0; i < element.count; ++i) {
                if (i % 65536 == 0) m_source.task.checkpoint();
                readElement(element);
            }
        return std::move(m_model);
    }

private:
    void findVertices() {
        int found = 0;
        int coordinates = 0;
        for (const Element& element : m_header.elements) {
            if (element.name != "vertex") continue;
            ++found;
            m_vertexCount = element.count;
            for (const Property& property : element.properties) {
                coordinates += property.name == "x" || property.name == "y" || property.name == "z";
                m_hasNormals = m_hasNormals || property.name == "nx";
            }
        }
        if (found != 1 || coordinates != 3)
            throw m_source.error("has no vertices with x, y and z", "the header should declare them once");
        checkVertexCount(m_source, m_vertexCount);
        mesh().positions.reserve(m_vertexCount);
        if (m_hasNormals) mesh().normals.reserve(m_vertexCount);
    }

    void readElement(const Element& element) {
        glm::vec3 position(0);
        glm::vec3 normal(0);
        for (const Property& property : element.properties) {
            if (property.countType) {
                readList(element, property);
                continue;
            }
            const auto value = float(m_body.next(property.type));
            if (property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
                position[property.name[0] - 'x'] = value;
            if (property.name.size() == 2 && property.name[0] == 'n' && property.name[1] >= 'x' &&
                property.name[1] <= 'z')
                normal[property.name[1] - 'x'] = value;
        }
        if (element.name != "vertex") return;
        mesh().positions.push_back(position);
        if (m_hasNormals) mesh().normals.push_back(normal);
    }

    void readList(const Element& element, const Property& property) {
        const double count = m_body.next(*property.countType);
        if (!(count >= 0 && count <= double(m_header.body.size())))
            throw m_source.error("a list promises " + wholeNumberText(count) + " entries",
                                 "it should hold no more than the file has room for");
        const bool strip = element.name == "tristrips";
        const bool used = (element.name == "face" || strip) &&
                          (property.name == "vertex_indices" || property.name == "vertex_index");
        m_corners.clear();
        for (double i = 0; i < count; ++i) {
            const double index = m_body.next(property.type);
            if (!used) continue;
            if (strip && index == -1) {
                addStrip();
                continue;
            }
            if (!(index >= 0 && index < double(m_vertexCount) && index == std::floor(index)))
                throw m_source.error("a face names a vertex that is not there (" + wholeNumberText(index) +
                                         " of " + std::to_string(m_vertexCount) + ")",
                                     "indices go from 0 to one less than the number of vertices");
            m_corners.push_back(std::uint32_t(index));
        }
        if (strip) {
            addStrip();
        } else if (used) {
            addPolygon(m_source, m_model, mesh(), m_corners);
        }
    }

    void addStrip() {
        for (std::size_t k = 2; k < m_corners.size(); ++k)
            addPolygon(m_source, m_model, mesh(),
                       {m_corners[k - 2 + k % 2], m_corners[k - 1 - k % 2], m_corners[k]});
        m_corners.clear();
    }

    Mesh& mesh() { return m_model.objects[0]; }

    const MeshSource& m_source;
    Header m_header;
    BodyReader m_body;
    RawModel m_model;
    bool m_hasNormals = false;
    std::size_t m_vertexCount = 0;
    std::vector<std::uint32_t> m_corners;
};

}  // namespace

RawModel readPly(const MeshSource& source) {
    return PlyReader(source).read();
}

}  // namespace chiaro::scene
