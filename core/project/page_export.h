#pragma once

#include "core/base/image_io.h"
#include "core/project/pipeline.h"

namespace chiaro::project {

/// A relightable page, and what it took.
struct ExportedPage {
    std::string html;
    std::size_t faces = 0;
    std::size_t objects = 0;
    double synthesisSeconds = 0;  ///< paints, and the textures of the objects' views
    double writeSeconds = 0;
};

/// The page (exporting::pageBytes) of a scene's visible objects with their samples' paint, by both methods
/// that it knows, whatever the project's is; it begins with that if it can, in this view. `path` is only
/// named in errors. Deterministic for any number of threads. Throws Error when no object is visible, there is
/// no sample, or pages can't be made; Cancelled.
ExportedPage exportPage(const std::filesystem::path& path, const std::string& title, const Project& project,
                        const scene::Scene& scene, const scene::Camera& camera, const ImageMetadata& metadata,
                        const Task& task = {}, const TextureCache* cache = nullptr);

}  // namespace chiaro::project
