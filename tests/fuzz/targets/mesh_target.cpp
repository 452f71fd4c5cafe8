// A libFuzzer program for one of our mesh readers; CHIARO_FUZZ_PARSER is its name.

#include "core/scene/mesh_readers.h"

#include <cstdint>
#include <cstdlib>

namespace {

using namespace chiaro;

/// What readModel goes on with: every face must name vertices that are there.
void check(const scene::RawModel& model) {
    std::size_t triangles = 0;
    for (const scene::Mesh& mesh : model.objects) {
        triangles += mesh.triangles.size();
        for (const scene::Triangle& triangle : mesh.triangles)
            for (const std::uint32_t vertex : triangle)
                if (vertex >= mesh.positions.size()) std::abort();
        if (model.facetted)
            scene::splitAtCreases(mesh, 40);
        else
            scene::angleWeightedNormals(mesh);
    }
    if (triangles != model.triangles) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Task task;
    try {
        check(scene::CHIARO_FUZZ_PARSER({"folder/mesh.file", bytes, task}));
    } catch (const Error&) {
    }
    return 0;
}
