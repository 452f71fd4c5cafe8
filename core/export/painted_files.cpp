#include "core/export/painted_files.h"

#include "core/base/color.h"

#include <spdlog/fmt/fmt.h>

namespace chiaro::exporting {

namespace {

/// Depth as files hold it: -1 outside, as in light pictures, since many programs refuse infinities.
ScalarImage finiteDepth(ScalarImage depth) {
    for (float& value : depth.pixels())
        if (std::isinf(value)) value = -1;
    return depth;
}

}  // namespace

void writePainted(const std::filesystem::path& path, ColorAlphaImage picture,
                  const std::optional<glm::vec3>& background, const ImageMetadata& metadata) {
    const bool isLinear = path.extension() == ".exr";
    if (background) {
        ColorImage opaque = methods::over(picture, *background);
        if (isLinear)
            for (glm::vec3& pixel : opaque.pixels()) pixel = linearFromSrgb(pixel);
        return writeImage(path, opaque, metadata);
    }
    if (isLinear)
        for (glm::vec4& pixel : picture.pixels())
            pixel = glm::vec4(linearFromSrgb(glm::vec3(pixel)), pixel.a);
    writeImage(path, picture, metadata);
}

std::filesystem::path AuxiliaryFolder::path(const std::string& name, int frame) const {
    const char* extension = name == "id" ? ".png" : ".exr";
    return m_folder / (frame > 0 ? fmt::format("{}.{:04}{}", name, frame, extension) : name + extension);
}

std::vector<std::filesystem::path> AuxiliaryFolder::ofFrame(int frame) const {
    std::vector<std::filesystem::path> files;
    if (isGiven())
        for (const char* name : {"light", "id", "texture", "depth", "normal", "motion"})
            files.push_back(path(name, frame));
    return files;
}

void AuxiliaryFolder::write(const scene::GBuffer& gbuffer, const methods::Frame& frame,
                            const ImageMetadata& metadata, int number) const {
    writeImage(path("light", number), gbuffer.light, metadata);
    writeImage(path("id", number), gbuffer.objectId, metadata);
    writeImage(path("texture", number), frame.texture, metadata);
    if (gbuffer.depth.empty()) return;  // guides have neither depth nor normals
    writeImage(path("depth", number), finiteDepth(gbuffer.depth), metadata);
    writeImage(path("normal", number), gbuffer.normal, metadata);
}

void AuxiliaryFolder::writeMotion(const Image<glm::vec2>& motion, const ImageMetadata& metadata,
                                  int number) const {
    writeImage(path("motion", number), motion, metadata);
}

}  // namespace chiaro::exporting
