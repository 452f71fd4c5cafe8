#pragma once

#include "app/cli/session.h"
#include "core/methods/method.h"

namespace chiaro::cli {

/// The flags that say how the pictures of a command look: their size, what lies behind the objects, and
/// whether the values they were shaded from are written too.
class PictureOutput {
public:
    /// Adds the flags; the output must outlive the parse.
    void addTo(CLI::App& command);
    /// Throws CLI::ValidationError when a flag's value is no such thing.
    void check() const;

    glm::ivec2 size() const;
    bool isTransparent() const { return m_background == "transparent"; }
    /// The picture over the background.
    ColorImage opaque(const ColorAlphaImage& picture) const;
    /// Writes it with or without its background; EXR holds scene-linear colours, the other formats
    /// display-referred ones. Throws Error.
    void write(const std::filesystem::path& path, ColorAlphaImage picture,
               const ImageMetadata& metadata) const;

    bool writesAuxiliary() const { return !m_auxiliary.empty(); }
    /// A file of the folder for such values: `light.exr`, or `light.0007.exr` for a frame.
    std::filesystem::path auxiliaryPath(const char* name, const char* extension, int frame = 0) const;
    /// light, id and texture, and of a mesh also depth and normal.
    void writeAuxiliary(const scene::GBuffer& gbuffer, const methods::Frame& frame,
                        const ImageMetadata& metadata, int number = 0) const;
    /// For metadata.
    nlohmann::json parameters() const;

private:
    std::string m_size = "1024x1024";
    std::string m_background = "#ffffff";
    std::filesystem::path m_auxiliary;
};

}  // namespace chiaro::cli
