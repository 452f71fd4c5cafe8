#pragma once

#include "app/cli/overwrite_flag.h"
#include "app/cli/path_flags.h"
#include "app/cli/picture_output.h"
#include "app/cli/project_source.h"
#include "core/export/video.h"
#include "core/project/animation_output.h"

#include <optional>

namespace chiaro::cli {

/// What is animated, how, and where its frames go: the flags that `animate` takes and a farm's chunks are
/// given.
class AnimationFlags {
public:
    /// Adds the flags; these must outlive the parse.
    void addTo(CLI::App& command);
    /// Throws CLI::ValidationError when the value of a flag is no such thing.
    void check() const;

    /// The project with the flags applied. Throws Error.
    project::Project load() const;
    /// Its frames: those that are asked for, else the render range of a project with keys, else 1-48.
    exporting::FrameRange range(const project::Animation& animation) const;
    /// The way of camera and lights: the project's keys, unless a path is given or nothing moves in them.
    scene::Path path(const project::Animation& animation) const;
    /// Where the project's frames go; what they tell of themselves comes with describe().
    project::AnimationOutput output(const project::Project& project) const;
    /// Makes the output's files tell what made them.
    void describe(project::AnimationOutput& output, const project::Shot& shot) const;

    /// Throws Error when a file that is read would be written too, when one is there already and neither
    /// --overwrite nor --resume is given, or when one can't be written.
    void checkFiles(const project::Project& project, const project::AnimationOutput& output) const;

    bool makesVideo() const { return exporting::isWritableVideo(m_output); }
    bool resumes() const { return m_resume; }
    const std::filesystem::path& pattern() const { return m_output; }
    glm::ivec2 size() const { return m_picture.size(); }

private:
    bool isKeyed(const project::Animation& animation) const;

    ProjectSource m_source;
    PictureOutput m_picture;
    PathFlags m_path{"turntable"};
    OverwriteFlag m_overwrite;
    std::vector<std::function<void(methods::CoherenceParams&)>> m_coherence;
    std::filesystem::path m_output;
    std::string m_frames;  ///< empty: the project's, where something moves in it
    std::optional<double> m_framesPerSecond;
    bool m_resume = false;
};

}  // namespace chiaro::cli
