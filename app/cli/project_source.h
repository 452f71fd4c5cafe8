#pragma once

#include "app/cli/session.h"
#include "core/project/picture_parameters.h"
#include "core/project/pipeline.h"

#include <memory>

namespace chiaro::cli {

/// The optional PROJECT and the flags that override what it says.
class ProjectSource {
public:
    /// Adds the flags; the source must outlive the parse.
    void addTo(CLI::App& command);

    /// What is painted: the project's mesh, or a view that comes from elsewhere.
    enum class Subject { Mesh, Guide };

    /// The project with the flags applied; for a guide without the mesh and its objects. Throws Error.
    project::Project load(Subject subject = Subject::Mesh) const;
    /// Whether a flag names the method.
    bool methodGiven() const { return m_methodGiven; }
    const std::filesystem::path& path() const { return m_path; }

private:
    using Override = std::function<void(project::Project&)>;
    void addSceneFlags(CLI::App& command);
    void addMethodFlags(CLI::App& command);
    template <class Params>
    void addOverrides(CLI::App& command, std::vector<Params& (*)(project::Project&)> members,
                      const std::string& prefix = {});

    std::filesystem::path m_path;
    std::vector<Override> m_overrides;
    bool m_methodGiven = false;
};

/// A project ready to be painted: its scene and one paint a sample.
struct LoadedProject {
    project::Project project;
    scene::Scene scene;
    std::vector<project::Paint> paints;  ///< one a sample of the project
};

/// One paint a sample of the project, with what its method needs. Throws Error, Cancelled.
std::vector<project::Paint> preparePaints(const project::Project& project, const Task& task);

/// Reads the meshes and places its objects as the project says. Throws Error, Cancelled.
scene::Scene readScene(const project::Project& project, const Task& task = {});

/// Reads mesh and samples and makes the paints. Throws Error, Cancelled.
LoadedProject loadProject(project::Project project, const Task& task);

using project::paintParameters;
using project::sceneParameters;

/// "1280x720", each side 1..16384, 64 megapixels in all. Throws CLI::ValidationError.
glm::ivec2 sizeFrom(const std::string& flag, const std::string& text);

}  // namespace chiaro::cli
