#pragma once

#include "core/base/image.h"
#include "core/scene/gbuffer.h"

#include <filesystem>
#include <vector>

namespace chiaro::test {

/// A GLB as a viewer reads it, by means that share nothing with what wrote it but tinygltf.
struct GlbScene {
    scene::Scene scene;                               ///< a node an object
    std::vector<std::vector<glm::vec2>> coordinates;  ///< of each object's vertices, y down
    std::string png;
    ColorImage texture;
    bool isUnlit = false;
    std::vector<std::string> requiredExtensions;
};
GlbScene readGlb(const std::filesystem::path& path);

/// The texture on the surface and nothing else, and where there is one: what an unlit viewer shows.
struct UnlitPicture {
    ColorImage color;
    Image<std::uint8_t> covered;
};
UnlitPicture unlitPicture(const GlbScene& glb, const scene::GBuffer& view);

}  // namespace chiaro::test
