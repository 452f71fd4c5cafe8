#pragma once

#include "core/base/image_io.h"
#include "core/methods/view_aligned.h"
#include "core/methods/view_dependent.h"
#include "core/scene/scene.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace chiaro::exporting {

/// A sample's paint for a page. Whose it is must outlive this.
struct PagePaint {
    const gradient::Gradient* shown = nullptr;
    const synthesis::LevelStack* levels = nullptr;  ///< empty: its objects show G(L) alone
};

/// An object as a page shows it.
struct PageObject {
    std::string name;
    std::shared_ptr<const scene::Mesh> mesh;
    glm::mat4 transform{1};                                 ///< object to world
    std::size_t paint = 0;                                  ///< index into PageScene::paints
    std::shared_ptr<const methods::PaintedObject> painted;  ///< null: G(L) alone
};

/// All that a relightable page shows.
struct PageScene {
    std::string title;
    std::vector<PagePaint> paints;
    std::vector<PageObject> objects;  ///< one at least
    std::vector<scene::Light> lights;
    scene::Camera camera;
    std::string method;  ///< that it begins with; the first when it shows none of this name
    methods::ViewAlignedParams viewAligned;
    methods::ViewDependentParams viewDependent;
};

/// True for a path that asks for a page: its extension is .html or .htm.
bool isPage(const std::filesystem::path& path);

/// A page that shows the scene by the view-aligned and the view-dependent method (§4.2, §4.3) in any light
/// and with any gradient, in any browser that knows WebGL 2: one HTML file that asks nothing of the network.
/// Meshes are a GLB, textures JPEG pictures of 8-bit differences. The same scene gives the same bytes. Throws
/// Error when the page's program was left out of the build, Cancelled.
std::string pageBytes(const std::filesystem::path& path, const PageScene& scene,
                      const ImageMetadata& metadata = {}, const Task& task = {});

/// Throws Error when pages can't be made. To be asked before the work begins.
void checkPageProgram();

}  // namespace chiaro::exporting
