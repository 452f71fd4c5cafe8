#pragma once

#include "core/base/task.h"
#include "core/project/project.h"
#include "core/project/texture_cache.h"
#include "core/scene/gbuffer.h"

#include <memory>
#include <vector>

namespace chiaro::project {

/// What one sample becomes on its way from the scan to the brush.
struct Paint {
    ColorImage strip;
    gradient::Separation separation;
    gradient::Gradient shown;      ///< the artist's recolouring, or else the sample's own gradient G(u(x))
    synthesis::LevelStack levels;  ///< empty when the method doesn't use them
    double levelSeconds = 0;       ///< what the level stack took to make
};

/// What an object of a view wears.
struct Worn {
    const Paint* paint = nullptr;
    std::shared_ptr<const methods::PaintedObject> views = nullptr;  ///< null when the method uses none
    glm::mat4 worldToObject{1};
};

/// [k - 1] of object k.
using WornPaints = std::vector<Worn>;

/// The gradient that pictures show for a sample.
gradient::Gradient shownGradient(const Sample& sample, const gradient::Separation& separation);

/// Scan, strip and separation of a sample, without levels. Throws Error, Cancelled.
Paint separatePaint(const Sample& sample, const Task& task = {});

/// Scan, strip, separation and level stack of a sample. Throws Error, Cancelled.
Paint preparePaint(const Sample& sample, const synthesis::LevelParams& levels, const Task& task = {});

/// What the project's method needs of one of its samples. Throws Error, Cancelled.
Paint preparePaint(const Project& project, std::size_t sample, const Task& task = {});

/// The meshes of a file, in their order there.
using MeshList = std::vector<std::shared_ptr<const scene::Mesh>>;

/// The scene of the loaded mesh files, one model each, with the project's settings applied; its objects are
/// those of allObjects(). An object that its file doesn't have has no mesh.
scene::Scene makeScene(const Project& project, const std::vector<MeshList>& models);

/// The project's camera, aimed at the scene when the project says so.
scene::Camera cameraFor(const Project& project, const scene::Scene& scene);

/// How much larger than its mesh an object stands in the scene.
double scaleOf(const scene::Object& object);

/// The views of an object of the scene: those that the artist placed, and what planning adds. The maps of the
/// scene's largest object are as large as the project says, those of the others as much smaller as they are,
/// so that strokes are of one size all over the scene. Throws Error, Cancelled.
std::shared_ptr<const methods::PlannedObject> planObject(const Project& project, const scene::Scene& scene,
                                                         std::size_t object, const Task& task = {});
/// The textures of a planned object's views: from the cache if it has them, else quilted and kept there.
/// Throws Error, Cancelled.
std::shared_ptr<const methods::PaintedObject> paintObject(
    const Project& project, std::shared_ptr<const methods::PlannedObject> planned, const Paint& paint,
    const Task& task = {}, const TextureCache* cache = nullptr);

/// What each object of the scene wears; `paints` has one entry a sample of the project. Makes the objects'
/// own textures when the project's method uses them. Throws Error, Cancelled.
WornPaints wornPaints(const Project& project, const scene::Scene& scene, const std::vector<Paint>& paints,
                      const Task& task = {}, const TextureCache* cache = nullptr);

/// A picture and what it took.
struct Rendering {
    methods::Frame frame;
    synthesis::QuiltReport report;  ///< of texture that was made for this picture
    double synthesisSeconds = 0;    ///< what that took
};

/// The picture of a view by the project's method, the texture where it lies when the objects are first seen.
/// worn[k - 1] is what object k of the view wears. Throws Error, Cancelled.
Rendering renderFrame(const Project& project, const WornPaints& worn, const scene::GBuffer& gbuffer,
                      const Task& task = {});

}  // namespace chiaro::project
