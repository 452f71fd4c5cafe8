#pragma once

#include "app/cli/session.h"
#include "core/project/pipeline.h"

#include <memory>

namespace chiaro::cli {

/// The optional PROJECT and the flags that override what it says.
class ProjectSource {
public:
    /// Adds the flags; the source must outlive the parse.
    void addTo(CLI::App& command);

    /// The project with the flags applied. Throws Error.
    project::Project load() const;
    const std::filesystem::path& path() const { return m_path; }

private:
    using Override = std::function<void(project::Project&)>;
    void addSceneFlags(CLI::App& command);
    void addMethodFlags(CLI::App& command);
    template <class Params>
    void addOverrides(CLI::App& command, Params& (*member)(project::Project&),
                      const std::string& prefix = {});

    std::filesystem::path m_path;
    std::vector<Override> m_overrides;
};

/// A project ready to be painted: its scene and one paint a sample.
struct LoadedProject {
    project::Project project;
    scene::Scene scene;
    std::vector<project::Paint> paints;  ///< one a sample of the project
};

/// Reads mesh and samples and synthesises the levels. Throws Error, Cancelled.
LoadedProject loadProject(project::Project project, const Task& task);

/// "1280x720", each side 1..16384, 64 megapixels in all. Throws CLI::ValidationError.
glm::ivec2 sizeFrom(const std::string& flag, const std::string& text);

}  // namespace chiaro::cli
