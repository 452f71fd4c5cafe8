#include "core/scene/byte_reader.h"
#include "core/scene/text_scanner.h"

namespace chiaro::scene {

namespace {

// STL's facet normals say nothing that the corners do not: they are passed over, and the creases are found
// from the angles between facets.

constexpr std::size_t headerSize = 84;
constexpr std::size_t facetSize = 50;

std::size_t promisedFacets(std::string_view bytes) {
    return bytes.size() < headerSize ? 0 : valueAt<std::uint32_t>(bytes, 80);
}

/// Files that begin with "solid" may be binary nevertheless; then they have the very size their count
/// promises.
bool isBinary(std::string_view bytes) {
    if (bytes.size() >= headerSize && bytes.size() == headerSize + facetSize * promisedFacets(bytes))
        return true;
    return !bytes.starts_with("solid") || bytes.substr(0, 4096).find('\0') != bytes.npos;
}

RawModel readBinary(const MeshSource& source) {
    const std::size_t facets = promisedFacets(source.bytes);
    if (source.bytes.size() < headerSize + facetSize * facets || source.bytes.size() < headerSize)
        throw source.error("promises " + std::to_string(facets) + " facets, more than its " +
                               std::to_string(source.bytes.size()) + " bytes can hold",
                           "a whole binary STL has 84 bytes and 50 for each facet");
    RawModel model;
    Mesh& mesh = model.objects.emplace_back();
    mesh.positions.reserve(facets * 3);
    mesh.triangles.reserve(facets);
    std::vector<std::uint32_t> corners;
    for (std::size_t f = 0; f < facets; ++f) {
        if (f % 65536 == 0) source.task.checkpoint();
        const std::size_t start = headerSize + facetSize * f + 12;
        corners.clear();
        for (std::size_t k = 0; k < 3; ++k) {
            corners.push_back(std::uint32_t(mesh.positions.size()));
            mesh.positions.emplace_back(valueAt<float>(source.bytes, start + 12 * k),
                                        valueAt<float>(source.bytes, start + 12 * k + 4),
                                        valueAt<float>(source.bytes, start + 12 * k + 8));
        }
        addPolygon(source, model, mesh, corners);
    }
    return model;
}

RawModel readText(const MeshSource& source) {
    RawModel model;
    TextScanner scanner(source, source.bytes, false);
    std::vector<std::uint32_t> corners;
    bool insideFacet = false;
    while (scanner.nextLine()) {
        const std::string_view keyword = scanner.word();
        if (keyword == "solid" && (insideFacet || !corners.empty()))
            throw scanner.error("a solid begins inside a facet", "a facet ends with endfacet");
        if (keyword == "solid") model.objects.emplace_back().name = scanner.rest();
        if (keyword == "facet") insideFacet = true;
        if (model.objects.empty()) throw scanner.error("a facet outside a solid", "begin with: solid NAME");
        Mesh& mesh = model.objects.back();
        if (keyword == "vertex") {
            corners.push_back(std::uint32_t(mesh.positions.size()));
            mesh.positions.push_back(scanner.position());
        }
        if (keyword == "endfacet") {
            addPolygon(source, model, mesh, corners);
            corners.clear();
            insideFacet = false;
        }
    }
    if (insideFacet) throw source.error("ends inside a facet", "a whole file ends with endsolid");
    return model;
}

}  // namespace

RawModel readStl(const MeshSource& source) {
    RawModel model = isBinary(source.bytes) ? readBinary(source) : readText(source);
    model.facetted = true;
    return model;
}

}  // namespace chiaro::scene
