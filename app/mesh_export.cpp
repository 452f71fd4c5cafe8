#include "app/mesh_export.h"

#include "app/worn_scene.h"

namespace chiaro::app {

exporting::AtlasReport exportMesh(const PictureSource& source, const MeshSettings& settings,
                                  const Task& task) {
    exporting::checkMeshOutput(settings.path, true);
    const WornScene worn(source, task.part(0, 0.6));
    const project::ExportedMesh mesh =
        project::paintMesh(source.project, source.scene, worn.worn(), exporting::meshFormat(settings.path),
                           settings.params, task.part(0.6, 0.95));
    task.checkpoint();
    exporting::writeTexturedScene(settings.path, mesh.scene, {{"Software", "Chiaro " CHIARO_VERSION}});
    return mesh.report;
}

}  // namespace chiaro::app
