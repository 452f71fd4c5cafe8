#pragma once

#include "core/base/image_io.h"
#include "core/methods/method.h"

#include <optional>

namespace chiaro::exporting {

/// Writes what a method painted, over the background (display-referred), or with its coverage when there is
/// none. EXR holds scene-linear colours, the other formats display-referred ones. Throws Error.
void writePainted(const std::filesystem::path& path, ColorAlphaImage picture,
                  const std::optional<glm::vec3>& background, const ImageMetadata& metadata);

/// A folder for the values that pictures were shaded from: light.exr, id.png, depth.exr, normal.exr and
/// texture.exr, or light.0007.exr for a frame.
class AuxiliaryFolder {
public:
    AuxiliaryFolder() = default;
    explicit AuxiliaryFolder(std::filesystem::path folder) : m_folder(std::move(folder)) {}

    /// Without a folder nothing is to be written.
    bool isGiven() const { return !m_folder.empty(); }
    /// `frame` is 0 for a picture by itself.
    std::filesystem::path path(const std::string& name, int frame = 0) const;
    /// All that is written for a frame of an animation, motion.exr included.
    std::vector<std::filesystem::path> ofFrame(int frame) const;

    /// Light and depth are -1 outside the objects. Of a guide there are neither depth nor normals. Throws
    /// Error.
    void write(const scene::GBuffer& gbuffer, const methods::Frame& frame, const ImageMetadata& metadata,
               int number = 0) const;
    /// The way of each pixel's surface to the next frame, in pixels, x right and y down. Throws Error.
    void writeMotion(const Image<glm::vec2>& motion, const ImageMetadata& metadata, int number) const;

private:
    std::filesystem::path m_folder;
};

}  // namespace chiaro::exporting
