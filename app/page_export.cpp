#include "app/page_export.h"

#include "core/base/atomic_file.h"
#include "core/project/page_export.h"

namespace chiaro::app {

void exportPage(const PictureSource& source, const std::filesystem::path& path, const Task& task) {
    checkOutputs({path}, true);
    const project::TextureCache cache(project::TextureCache::standardFolder());
    const project::ExportedPage page =
        project::exportPage(path, path.stem().string(), source.project, source.scene, source.camera,
                            {{"Software", "Chiaro " CHIARO_VERSION}}, task.part(0, 0.98), &cache);
    task.checkpoint();
    writeFileAtomically(path, page.html);
}

}  // namespace chiaro::app
