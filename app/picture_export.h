#pragma once

#include "core/base/task.h"
#include "core/methods/view_aligned.h"
#include "core/methods/view_dependent.h"
#include "core/project/project.h"
#include "core/scene/scene.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace chiaro::app {

/// What the artist chose for a picture.
struct PictureSettings {
    std::filesystem::path path;
    int width = 1920;         ///< px, 16..16384
    int height = 1080;        ///< px
    bool transparent = true;  ///< else over `background`
    glm::vec3 background{0};  ///< display-referred RGB
    bool keepsScale = true;   ///< strokes as large against the picture as they are against the viewport
};

/// The paint of one sample, as far as it is made; what is missing is made for the picture.
struct PicturePaint {
    std::shared_ptr<const synthesis::LevelStack> levels;
    gradient::Gradient gradient;
};

/// All that a picture is made from: values and immutable snapshots.
struct PictureSource {
    project::Project project;
    scene::Scene scene;
    scene::Camera camera;
    std::vector<PicturePaint> paints;                   ///< one a sample
    std::vector<methods::TexturePlacement> placements;  ///< one an object, in the viewport's pixels
    int viewportWidth = 1920;                           ///< px
    int viewportHeight = 1080;
    /// One an object, of its own views; null: to be made for the picture, if its method uses them.
    std::vector<std::shared_ptr<const methods::PaintedObject>> objectTextures = {};
};

/// Renders by core and by the project's method, deterministic, and writes the picture atomically. Throws
/// Error, Cancelled.
void exportPicture(PictureSource source, const PictureSettings& settings, const Task& task);

}  // namespace chiaro::app
