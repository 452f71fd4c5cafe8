#include "app/cli/picture_output.h"

#include "app/cli/project_source.h"
#include "core/base/color.h"

namespace chiaro::cli {

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

std::optional<glm::vec3> PictureOutput::background() const {
    if (isTransparent()) return std::nullopt;
    return colorFromHex(m_background);
}

nlohmann::json PictureOutput::parameters() const {
    const glm::ivec2 pixels = size();
    return {{"size", {pixels.x, pixels.y}}, {"background", m_background}};
}

}  // namespace chiaro::cli
