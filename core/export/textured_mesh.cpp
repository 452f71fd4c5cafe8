#include "core/export/textured_mesh.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/export/mesh_writers.h"

#include <algorithm>
#include <cctype>

namespace chiaro::exporting {

namespace fs = std::filesystem;

MeshFormat meshFormat(const fs::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    if (extension == ".glb") return MeshFormat::Glb;
    if (extension == ".obj") return MeshFormat::Obj;
    if (extension == ".ply") return MeshFormat::Ply;
    throw Error(path.string(), "has no extension of a mesh that is written", "choose .glb, .obj or .ply");
}

std::vector<fs::path> filesOf(const fs::path& path) {
    if (meshFormat(path) != MeshFormat::Obj) return {path};
    // Many programs take a name in an OBJ file to end at its first space.
    std::string stem = path.stem().string();
    std::ranges::replace(stem, ' ', '_');
    return {path, path.parent_path() / (stem + ".mtl"), path.parent_path() / (stem + ".png")};
}

void checkMeshOutput(const fs::path& path, bool mayReplace) {
    checkOutputs(filesOf(path), mayReplace);
}

bool hasModelledBacks(const scene::Mesh& mesh) {
    const std::vector<std::uint32_t> welded = scene::weldedIndices(mesh);
    struct Face {
        scene::Triangle corners;  ///< ascending
        bool isTurned;            ///< against the order that the face has them in
    };
    std::vector<Face> faces;
    for (const scene::Triangle& triangle : mesh.triangles) {
        scene::Triangle corners{welded[triangle[0]], welded[triangle[1]], welded[triangle[2]]};
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        const bool isTurned = corners[1] > corners[2];
        if (isTurned) std::swap(corners[1], corners[2]);
        faces.push_back({corners, isTurned});
    }
    std::ranges::sort(faces, {}, &Face::corners);
    std::size_t paired = 0;
    for (std::size_t i = 1; i < faces.size(); ++i)
        if (faces[i].corners == faces[i - 1].corners && faces[i].isTurned != faces[i - 1].isTurned)
            paired += 2;
    return 4 * paired > faces.size();
}

TexturedObject withCoordinates(const scene::Object& object, const AtlasFaces& faces, int atlasSize) {
    const scene::Mesh& mesh = *object.mesh;
    TexturedObject result;
    result.name = object.name;
    result.transform = object.transform;
    result.isDoubleSided = !hasModelledBacks(mesh);
    result.triangles.resize(mesh.triangles.size());
    // Chart after chart, so that a vertex knows by its last chart whether it is there already.
    std::vector<std::uint32_t> order(mesh.triangles.size());
    for (std::uint32_t face = 0; face < order.size(); ++face) order[face] = face;
    std::ranges::stable_sort(order, {}, [&](std::uint32_t face) { return faces.chart[face]; });
    std::vector<std::uint32_t> lastChart(mesh.positions.size(), 0xFFFFFFFF), lastIndex(mesh.positions.size());
    for (const std::uint32_t face : order)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = mesh.triangles[face][k];
            if (lastChart[vertex] != faces.chart[face]) {
                lastChart[vertex] = faces.chart[face];
                lastIndex[vertex] = std::uint32_t(result.positions.size());
                result.positions.push_back(mesh.positions[vertex]);
                result.normals.push_back(mesh.normals[vertex]);
                result.coordinates.push_back(faces.corners[face][k] / float(atlasSize));
            }
            result.triangles[face][k] = lastIndex[vertex];
        }
    return result;
}

void writeTexturedScene(const fs::path& path, const TexturedScene& scene, const ImageMetadata& metadata) {
    switch (meshFormat(path)) {
        case MeshFormat::Glb:
            return writeFileAtomically(path, glbBytes(path, scene, metadata));
        case MeshFormat::Obj: {
            const std::vector<fs::path> files = filesOf(path);
            return writeFilesAtomically({{files[2], pngBytes(files[2], scene.texture, metadata)},
                                         {files[1], mtlBytes(files[2].filename(), scene, metadata)},
                                         {files[0], objBytes(files[1].filename(), scene, metadata)}});
        }
        case MeshFormat::Ply:
            return writeFileAtomically(path, plyBytes(scene, metadata));
    }
}

}  // namespace chiaro::exporting
