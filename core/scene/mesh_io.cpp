#include "core/scene/mesh_io.h"

#include "core/base/atomic_file.h"
#include "core/base/import.h"
#include "core/scene/mesh_import.h"
#include "core/scene/mesh_readers.h"
#include "core/scene/mesh_tasks.h"
#include "core/scene/text_scanner.h"

#include <unordered_map>

namespace chiaro::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t maximumFileSize = std::uintmax_t(2) << 30;
constexpr float farthestVertex = 1e15f;  // squared distances must stay finite
constexpr float creaseDegrees = 40;

using Reader = RawModel (*)(const MeshSource&);

std::string lowerExtension(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return extension;
}

/// The content decides where it is unmistakable, else the extension.
Reader readerFor(const MeshSource& source) {
    const std::string_view bytes = source.bytes;
    const std::string extension = lowerExtension(source.path);
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return readPly;
    if (bytes.starts_with("glTF")) return readGltf;
    for (const std::string_view keyword : {"OFF", "COFF", "NOFF", "CNOFF"})
        if (bytes.starts_with(keyword) && bytes.substr(keyword.size()).find_first_of(" \t\r\n") == 0)
            return readOff;
    if (bytes.starts_with("solid") && bytes.find("facet") != bytes.npos) return readStl;
    if (extension == ".obj") return readObj;
    if (extension == ".ply") return readPly;
    if (extension == ".off") return readOff;
    if (extension == ".stl") return readStl;
    if (extension == ".glb") throw source.error("is no GLB", "a GLB begins with the letters glTF");
    if (extension == ".gltf") return readGltf;
    throw source.error("is no mesh format that can be read",
                       "OBJ, PLY, OFF, STL, GLB or glTF would be; the name should end so");
}

void checkPositions(const MeshSource& source, const Mesh& mesh) {
    for (const glm::vec3& position : mesh.positions) {
        if (glm::any(glm::isnan(position)) || glm::any(glm::isinf(position)))
            throw source.error("has vertices that are not finite",
                               "every coordinate must be a finite number");
        if (glm::any(glm::greaterThan(glm::abs(position), glm::vec3(farthestVertex))))
            throw source.error("has vertices more than 1e15 away from the origin", "scale the mesh down");
    }
}

/// For each vertex the sum of the unit normals of the faces that use this very vertex, not those across a
/// crease.
std::vector<glm::vec3> ownFaceNormals(const Mesh& mesh) {
    std::vector<glm::vec3> own(mesh.positions.size(), glm::vec3(0));
    for (const Triangle& triangle : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[triangle[0]]);
        const glm::dvec3 cross = glm::cross(glm::dvec3(mesh.positions[triangle[1]]) - a,
                                            glm::dvec3(mesh.positions[triangle[2]]) - a);
        const double length = glm::length(cross);
        if (!(length > 0)) continue;
        for (const std::uint32_t vertex : triangle) own[vertex] += glm::vec3(cross / length);
    }
    return own;
}

/// False for a file whose normals have nothing to do with its faces, such as one direction for a whole ball.
/// Turned about they may be: many files disagree with themselves about the front.
bool normalsMakeSense(const std::vector<Mesh>& meshes) {
    double sum = 0;
    double count = 0;
    for (const Mesh& mesh : meshes) {
        if (mesh.normals.size() != mesh.positions.size()) continue;
        const std::vector<glm::vec3> own = ownFaceNormals(mesh);
        for (std::size_t i = 0; i < own.size(); ++i) {
            const float lengths = glm::length(own[i]) * glm::length(mesh.normals[i]);
            if (!(lengths > 1e-6f) || !std::isfinite(lengths)) continue;
            sum += double(std::abs(glm::dot(own[i], mesh.normals[i])) / lengths);
            ++count;
        }
    }
    return sum >= 0.6 * count;  // unrelated directions average 0.5
}

/// The file's normals are kept, at unit length, if they are to be trusted and where they have a direction;
/// the others are computed. Tells how many of the file's were replaced.
std::size_t completeNormals(Mesh& mesh, bool trusted, const Task& task) {
    const bool given = mesh.normals.size() == mesh.positions.size();
    std::vector<glm::vec3> computed = angleWeightedNormals(mesh, task);
    std::size_t replaced = 0;
    for (std::size_t i = 0; given && i < computed.size(); ++i) {
        const float length = glm::length(mesh.normals[i]);
        const bool usable = trusted && length > 1e-6f && std::isfinite(length);
        if (usable) computed[i] = mesh.normals[i] / length;
        replaced += !usable && mesh.normals[i] != glm::vec3(0);
    }
    mesh.normals = std::move(computed);
    return replaced;
}

/// Every object gets a name, and one of its own: the file's, cleaned up, with a number where it occurs again.
void nameObjects(std::vector<Mesh>& meshes, const fs::path& path) {
    std::unordered_map<std::string, int> timesSeen;
    for (Mesh& mesh : meshes) {
        std::string name = cleanName(mesh.name);
        if (name.empty()) name = cleanName(path.stem().string());
        mesh.name = name;
        // A numbered name may itself be one that the file has.
        for (int number = ++timesSeen[name]; number > 1; number = ++timesSeen[name]) {
            mesh.name = name + " (" + std::to_string(number) + ")";
            if (timesSeen.try_emplace(mesh.name, 1).second) break;
        }
    }
}

std::string counted(std::size_t count, const std::string& singular, const std::string& plural) {
    return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

}  // namespace

Error MeshSource::error(std::string_view problem, std::string_view remedy) const {
    constexpr std::size_t longestProblem = 300;
    return Error(path.string(), cleanName(problem, longestProblem), remedy);
}

void checkVertexCount(const MeshSource& source, std::size_t count) {
    if (count > 3 * maximumTriangles)
        throw source.error("has " + std::to_string(count) + " vertices",
                           "at most " + std::to_string(3 * maximumTriangles) + " are read");
}

void checkTriangleCount(const MeshSource& source, std::size_t count) {
    if (count > maximumTriangles)
        throw source.error("has more than " + std::to_string(maximumTriangles) + " triangles",
                           "simplify the mesh");
}

void addPolygon(const MeshSource& source, RawModel& model, Mesh& mesh,
                const std::vector<std::uint32_t>& corners) {
    if (corners.size() < 3) {
        ++model.skippedFaces;
        return;
    }
    model.triangles += corners.size() - 2;
    checkTriangleCount(source, model.triangles);
    for (std::size_t k = 2; k < corners.size(); ++k)
        mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

Model readModel(const fs::path& path, const Task& task) {
    if (helper::HelperPool* helpers = importHelpers()) return importModel(*helpers, path, task);
    std::string bytes = readFile(path, maximumFileSize);
    if (bytes.empty()) throw Error(path.string(), "is empty", "a mesh file would have vertices and faces");
    if (std::string decoded = decodedUtf16(bytes); !decoded.empty()) bytes = std::move(decoded);
    const MeshSource source{path, bytes, task};
    RawModel raw = readerFor(source)(source);
    std::erase_if(raw.objects, [](const Mesh& mesh) { return mesh.triangles.empty(); });
    if (raw.triangles == 0)
        throw source.error("has no faces", "a mesh with at least one triangle would be shaded");
    if (raw.objects.size() > maximumObjects)
        throw source.error("has " + std::to_string(raw.objects.size()) + " objects",
                           "at most " + std::to_string(maximumObjects) + " are read");
    task.report(0.6);

    Model model;
    model.warnings = std::move(raw.warnings);
    std::size_t replacedNormals = 0;
    task.checkpoint();
    const bool trusted = normalsMakeSense(raw.objects);
    for (Mesh& mesh : raw.objects) {
        task.checkpoint();
        checkPositions(source, mesh);
        if (raw.facetted)
            mesh = splitAtCreases(mesh, creaseDegrees, task);
        else
            replacedNormals += completeNormals(mesh, trusted, task);
        task.report(0.6 + 0.3 * double(&mesh - raw.objects.data() + 1) / double(raw.objects.size()));
    }
    task.checkpoint();
    const Topology topology =
        topologyOf(raw.objects.size() == 1 ? raw.objects[0] : merged(raw.objects), task);
    model.degenerateFaces = topology.degenerateFaces;
    if (model.degenerateFaces == raw.triangles)
        throw source.error("has no face with an area",
                           "a mesh with at least one real triangle would be shaded");
    model.nonManifoldEdges = topology.nonManifoldEdges;
    model.boundaryEdges = topology.boundaryEdges;
    model.faces = raw.triangles;
    model.meshes = std::move(raw.objects);
    nameObjects(model.meshes, path);
    if (raw.skippedFaces > 0)
        model.warnings.push_back(counted(raw.skippedFaces, "face has", "faces have") +
                                 " fewer than three corners and can't be drawn.");
    if (model.degenerateFaces > 0)
        model.warnings.push_back(counted(model.degenerateFaces, "face has", "faces have") + " no area.");
    if (replacedNormals > 0)
        model.warnings.push_back(counted(replacedNormals, "normal", "normals") +
                                 " in the file made no sense and were computed instead.");
    return model;
}

}  // namespace chiaro::scene
