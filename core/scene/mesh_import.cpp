#include "core/scene/mesh_import.h"

#include "core/base/helper/file_request.h"
#include "core/scene/mesh_readers.h"
#include "core/scene/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace chiaro::scene {

namespace {

namespace fs = std::filesystem;

using helper::PlainReader;
using helper::PlainWriter;

constexpr std::size_t longestText = 1000;  // of a name or a warning, in bytes

/// The sizes that tell what lies in the shared memory.
struct Counts {
    std::size_t meshes = 0;
    std::size_t warnings = 0;
    std::size_t faces = 0;
    std::size_t degenerateFaces = 0;
    std::size_t nonManifoldEdges = 0;
    std::size_t boundaryEdges = 0;
};

struct MeshCounts {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
};

/// Names and sizes first, then the lists, which are large.
std::string describe(const Model& model) {
    PlainWriter head;
    head.add(Counts{model.meshes.size(), model.warnings.size(), model.faces, model.degenerateFaces,
                    model.nonManifoldEdges, model.boundaryEdges});
    for (const std::string& warning : model.warnings) head.addText(warning);
    for (const Mesh& mesh : model.meshes) {
        head.addText(mesh.name);
        head.add(MeshCounts{mesh.positions.size(), mesh.triangles.size()});
    }
    return head.take();
}

helper::FileHandle share(const Model& model) {
    const std::string head = describe(model);
    std::size_t size = head.size();
    for (const Mesh& mesh : model.meshes)
        size += 2 * mesh.positions.size() * sizeof(glm::vec3) + mesh.triangles.size() * sizeof(Triangle);
    helper::SharedWriter memory(size);
    std::byte* to = memory.data();
    const auto append = [&](const void* from, std::size_t bytes) {
        if (bytes > 0) std::memcpy(to, from, bytes);
        to += bytes;
    };
    append(head.data(), head.size());
    for (const Mesh& mesh : model.meshes) {
        append(mesh.positions.data(), mesh.positions.size() * sizeof(glm::vec3));
        append(mesh.normals.data(), mesh.normals.size() * sizeof(glm::vec3));
        append(mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
    }
    return memory.seal();
}

bool allFinite(const std::vector<glm::vec3>& vectors) {
    return std::ranges::all_of(vectors, [](const glm::vec3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    });
}

bool isSound(const Mesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    const auto isInside = [&](const Triangle& triangle) {
        return triangle[0] < vertices && triangle[1] < vertices && triangle[2] < vertices;
    };
    return !mesh.name.empty() && !mesh.triangles.empty() && allFinite(mesh.positions) &&
           allFinite(mesh.normals) && std::ranges::all_of(mesh.triangles, isInside);
}

Model understand(std::span<const std::byte> bytes) {
    PlainReader reader(bytes);
    const auto counts = reader.take<Counts>();
    Model model;
    model.faces = counts.faces;
    model.degenerateFaces = counts.degenerateFaces;
    model.nonManifoldEdges = counts.nonManifoldEdges;
    model.boundaryEdges = counts.boundaryEdges;
    for (std::size_t i = 0; i < counts.warnings; ++i)
        model.warnings.push_back(cleanName(reader.takeText(), longestText));
    std::vector<MeshCounts> sizes;
    for (std::size_t i = 0; i < counts.meshes; ++i) {
        model.meshes.emplace_back().name = cleanName(reader.takeText(), longestText);
        sizes.push_back(reader.take<MeshCounts>());
    }
    std::size_t faces = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        Mesh& mesh = model.meshes[i];
        mesh.positions = reader.takeList<glm::vec3>(sizes[i].vertices);
        mesh.normals = reader.takeList<glm::vec3>(sizes[i].vertices);
        mesh.triangles = reader.takeList<Triangle>(sizes[i].triangles);
        faces += mesh.triangles.size();
        if (!isSound(mesh)) throw std::runtime_error("a mesh that is none");
    }
    const bool areCountsSound = faces == counts.faces && counts.degenerateFaces < faces && reader.atEnd();
    if (!areCountsSound || faces > maximumTriangles || model.meshes.size() > maximumObjects)
        throw std::runtime_error("counts that do not agree");
    return model;
}

}  // namespace

Model importModel(helper::HelperPool& helpers, const fs::path& path, const Task& task) {
    const helper::Answer answer =
        helpers.ask(helper::fileRequest(modelRequest, path).take(), path, task.part(0, 0.95));
    Model model = helper::understood(path, [&] { return understand(answer.memory.bytes()); });
    task.report(1);
    return model;
}

helper::Finding handleModelRequest(PlainReader& request, const Task& task) {
    return {{}, share(readModel(request.takeText(), task))};
}

}  // namespace chiaro::scene
