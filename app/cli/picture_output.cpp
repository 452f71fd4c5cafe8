#include "app/cli/picture_output.h"

#include "app/cli/project_source.h"
#include "core/base/color.h"

#include <spdlog/fmt/fmt.h>

namespace chiaro::cli {

namespace {

/// Depth as files hold it: -1 outside, as in light pictures, since many programs refuse infinities.
ScalarImage finiteDepth(ScalarImage depth) {
    for (float& value : depth.pixels())
        if (std::isinf(value)) value = -1;
    return depth;
}

}  // namespace

void PictureOutput::addTo(CLI::App& command) {
    command.add_option("--size", m_size,
                       "WIDTHxHEIGHT, each 1..16384 px, together at most 64 megapixels (default 1024x1024)");
    command.add_option("--background", m_background, "#rrggbb or transparent (default #ffffff)");
    command.add_option(
        "--aux", m_auxiliary,
        "Folder for light.exr, id.png, depth.exr, normal.exr and texture.exr of each picture, of "
        "a frame with its number and with motion.exr, the way to the next one in px; light and "
        "depth are -1 outside the objects");
}

void PictureOutput::check() const {
    size();
    if (!isTransparent()) usageFrom("--background", [this] { colorFromHex(m_background); });
}

glm::ivec2 PictureOutput::size() const {
    return sizeFrom("--size", m_size);
}

ColorImage PictureOutput::opaque(const ColorAlphaImage& picture) const {
    return methods::over(picture, colorFromHex(m_background));
}

void PictureOutput::write(const std::filesystem::path& path, ColorAlphaImage picture,
                          const ImageMetadata& metadata) const {
    const bool isLinear = path.extension() == ".exr";
    if (!isTransparent()) {
        ColorImage opaquePicture = opaque(picture);
        if (isLinear)
            for (glm::vec3& pixel : opaquePicture.pixels()) pixel = linearFromSrgb(pixel);
        return writeImage(path, opaquePicture, metadata);
    }
    if (isLinear)
        for (glm::vec4& pixel : picture.pixels())
            pixel = glm::vec4(linearFromSrgb(glm::vec3(pixel)), pixel.a);
    writeImage(path, picture, metadata);
}

std::filesystem::path PictureOutput::auxiliaryPath(const char* name, const char* extension, int frame) const {
    return m_auxiliary / (frame > 0 ? fmt::format("{}.{:04}{}", name, frame, extension)
                                    : fmt::format("{}{}", name, extension));
}

void PictureOutput::writeAuxiliary(const scene::GBuffer& gbuffer, const methods::Frame& frame,
                                   const ImageMetadata& metadata, int number) const {
    writeImage(auxiliaryPath("light", ".exr", number), gbuffer.light, metadata);
    writeImage(auxiliaryPath("id", ".png", number), gbuffer.objectId, metadata);
    writeImage(auxiliaryPath("texture", ".exr", number), frame.texture, metadata);
    if (gbuffer.depth.empty()) return;  // guides have neither depth nor normals
    writeImage(auxiliaryPath("depth", ".exr", number), finiteDepth(gbuffer.depth), metadata);
    writeImage(auxiliaryPath("normal", ".exr", number), gbuffer.normal, metadata);
}

nlohmann::json PictureOutput::parameters() const {
    const glm::ivec2 pixels = size();
    return {{"size", {pixels.x, pixels.y}}, {"background", m_background}};
}

}  // namespace chiaro::cli
