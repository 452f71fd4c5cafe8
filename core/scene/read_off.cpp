#include "core/scene/text_scanner.h"

#include <optional>

namespace chiaro::scene {

namespace {

/// OFF: a keyword, counts, a line a vertex, a line a face. Of the variants, those with normals (N) and
/// colours (C) are read; the colours are passed over.
class OffReader {
public:
    explicit OffReader(const MeshSource& source) : m_source(source), m_scanner(source, source.bytes) {}

    RawModel read() {
        readHeader();
        Mesh& mesh = m_model.objects.emplace_back();
        mesh.positions.reserve(m_vertices);
        for (std::size_t i = 0; i < m_vertices; ++i) {
            if (!m_scanner.nextLine()) throw truncated("vertices", i, m_vertices);
            mesh.positions.push_back(m_scanner.position());
            if (m_hasNormals) mesh.normals.push_back(m_scanner.direction());
        }
        for (std::size_t i = 0; i < m_faces; ++i) {
            if (!m_scanner.nextLine()) throw truncated("faces", i, m_faces);
            readFace(mesh);
        }
        return std::move(m_model);
    }

private:
    void readHeader() {
        m_scanner.nextLine();
        const std::string_view keyword = m_scanner.word();
        if (keyword == "OFF" || keyword == "COFF" || keyword == "NOFF" || keyword == "CNOFF") {
            m_hasNormals = keyword.find('N') != keyword.npos;
        } else {
            throw m_scanner.error("\"" + std::string(keyword.substr(0, 40)) + "\" is no OFF that is read",
                                  "the file should begin with OFF, COFF, NOFF or CNOFF");
        }
        m_vertices = readCount("vertices");
        m_faces = readCount("faces");
        checkVertexCount(m_source, m_vertices);
    }

    // The counts are believed only as far as the file has room for them: "0 0 0\n" and "3 0 0 0\n" at least.
    std::size_t readCount(std::string_view what) {
        const std::string_view text = m_scanner.wordAnywhere();
        if (text == "BINARY") throw m_scanner.error("binary OFF is not read", "save it as text or as PLY");
        const std::optional<long long> count = TextScanner::integerOf(text);
        if (!count || *count < 0)
            throw m_scanner.error(
                "\"" + std::string(text.substr(0, 40)) + "\" is no number of " + std::string(what),
                "the counts should follow the keyword");
        if (std::size_t(*count) > m_source.bytes.size() / 4)
            throw m_scanner.error("the header promises " + std::to_string(*count) + " " + std::string(what) +
                                      ", more than the file has room for",
                                  "the counts should match the file");
        return std::size_t(*count);
    }

    void readFace(Mesh& mesh) {
        const std::optional<long long> count = TextScanner::integerOf(m_scanner.word());
        if (!count || *count < 0)
            throw m_scanner.error("the face does not begin with its number of corners", "faces read 3 0 1 2");
        m_corners.clear();
        for (long long k = 0; k < *count; ++k) {
            const std::string_view text = m_scanner.word();
            const std::optional<long long> index = TextScanner::integerOf(text);
            if (!index)
                throw m_scanner.error(
                    "the face has fewer corners than it promises (" + std::to_string(*count) + ")",
                    "faces read 3 0 1 2");
            if (*index < 0 || *index >= (long long)(m_vertices))
                throw m_scanner.error(
                    "the face names vertex " + std::to_string(*index) + " of " + std::to_string(m_vertices),
                    "indices go from 0 to one less than the number of vertices");
            m_corners.push_back(std::uint32_t(*index));
        }
        addPolygon(m_source, m_model, mesh, m_corners);
    }

    Error truncated(std::string_view what, std::size_t found, std::size_t promised) const {
        return m_source.error("ends after " + std::to_string(found) + " of " + std::to_string(promised) +
                                  " " + std::string(what),
                              "a whole file would hold them all");
    }

    const MeshSource& m_source;
    TextScanner m_scanner;
    RawModel m_model;
    std::size_t m_vertices = 0;
    std::size_t m_faces = 0;
    bool m_hasNormals = false;
    std::vector<std::uint32_t> m_corners;
};

}  // namespace

RawModel readOff(const MeshSource& source) {
    return OffReader(source).read();
}

}  // namespace chiaro::scene
