#pragma once

#include "core/base/error.h"
#include "core/base/task.h"
#include "core/scene/mesh.h"

#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace chiaro::scene {

// One reader a format, each a function from bytes to plain values that trusts no number in the file: whatever
// is allocated is bounded by the size of the file. All but glTF are our own, small enough to be careful:
// assimp forgets the order of the faces, which face numbers depend on, and allocates what an OFF header
// claims; OpenMesh's readers crash on bad indices.

constexpr std::size_t maximumTriangles = 20'000'000;
constexpr std::size_t maximumObjects = 65535;  // object ids have 16 bits
constexpr std::uint32_t noIndex = std::numeric_limits<std::uint32_t>::max();

/// A whole mesh file in memory.
struct MeshSource {
    std::filesystem::path path;
    std::string_view bytes;
    const Task& task;

    /// A problem may quote the file, whatever stands there.
    Error error(std::string_view problem, std::string_view remedy) const;
};

/// What a reader found, before readModel checks vertices, completes normals and tells names apart. Names may
/// be empty or equal; normals may be empty or of any length, zero where the file has none.
struct RawModel {
    std::vector<Mesh> objects;
    std::vector<std::string> warnings;
    std::size_t triangles = 0;     ///< of all objects
    std::size_t skippedFaces = 0;  ///< with fewer than three corners
    bool facetted = false;         ///< faces know no shared vertices: find the creases
};

RawModel readObj(const MeshSource& source);
RawModel readPly(const MeshSource& source);
RawModel readOff(const MeshSource& source);
RawModel readStl(const MeshSource& source);
RawModel readGltf(const MeshSource& source);

/// Throws Error when there are more than maximumTriangles could use.
void checkVertexCount(const MeshSource& source, std::size_t count);

/// Throws Error beyond maximumTriangles.
void checkTriangleCount(const MeshSource& source, std::size_t count);

/// Appends a polygon as a fan around its first corner; fewer than three corners only count as skipped. Throws
/// Error beyond maximumTriangles, counted over the file so far.
void addPolygon(const MeshSource& source, RawModel& model, Mesh& mesh,
                const std::vector<std::uint32_t>& corners);

}  // namespace chiaro::scene
