#pragma once

#include "app/cli/session.h"
#include "core/project/pipeline.h"

namespace chiaro::cli {

/// The flags that put a picture of light, and one of object ids, in the place of a mesh.
class GuideSource {
public:
    /// Adds the flags to a command that has those of a ProjectSource; the source must outlive the parse.
    void addTo(CLI::App& command);

    bool given() const { return !m_light.empty(); }
    /// The view that the pictures describe. Throws Error.
    scene::GBuffer read() const;
    /// What each object of that view wears: --object names them by their numbers; others wear the first
    /// sample. Throws Error when the view hasn't an object that the project names.
    project::WornPaints wornPaints(const project::Project& project, const scene::GBuffer& view,
                                   const std::vector<project::Paint>& paints) const;
    /// The files that are read; empty without them.
    std::vector<std::filesystem::path> inputs() const { return {m_light, m_ids}; }
    /// For a picture's metadata.
    nlohmann::json parameters() const;

private:
    std::filesystem::path m_light;
    std::filesystem::path m_ids;
};

}  // namespace chiaro::cli
