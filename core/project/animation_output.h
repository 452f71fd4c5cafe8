#pragma once

#include "core/export/frame_sequence.h"
#include "core/export/painted_files.h"
#include "core/project/animation.h"

namespace chiaro::project {

/// Where the frames of a shot go, and how.
struct AnimationOutput {
    std::filesystem::path path;  ///< name.####.png (.exr, .tif), #### being the frame; or .mp4, .webm, .mkv
    exporting::FrameRange range;
    std::optional<glm::vec3> background;   ///< display-referred; none: transparent, which videos can't be
    exporting::AuxiliaryFolder auxiliary;  ///< for the values behind each frame
    double rate = 24;                      ///< frames a second of a video
    bool resume = false;                   ///< keep frames that are finished
    std::function<ImageMetadata(int frame)> metadata;  ///< what a frame's files are to tell of themselves

    bool isVideo() const;
    /// Everything that is written, in the order of the frames.
    std::vector<std::filesystem::path> files() const;
};

/// Throws Error when an animation can't be written under such a name.
void checkAnimationPath(const std::filesystem::path& path);

/// True when the file holds a whole picture of this size that tells all of this of itself.
bool isFinishedPicture(const std::filesystem::path& path, const ImageMetadata& metadata, glm::ivec2 size);

/// Paints the frames and writes them, each file whole or not at all. Cancelled or failing amid it, frames
/// that are finished stay and no video does. Returns how many frames were finished before. Throws Error,
/// Cancelled.
int writeAnimation(const Shot& shot, const AnimationOutput& output, const Task& task);

}  // namespace chiaro::project
