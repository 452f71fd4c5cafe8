#pragma once

#include "core/base/image.h"
#include "core/base/task.h"
#include "core/export/frame_sequence.h"

#include <vector>

namespace chiaro::exporting {

/// What is wrong with the frames of a sequence; each list ascends.
struct SequenceReport {
    std::vector<int> missing;
    std::vector<int> damaged;    ///< no whole picture, or of another size than most
    std::vector<int> different;  ///< not made by the command that made most of them, or from other files
    bool isWhole() const { return missing.empty() && damaged.empty() && different.empty(); }
    /// "frames 3, 7-9 are missing, frame 12 is damaged"; empty when it is whole.
    std::string text() const;
};

/// Reads every frame. Throws Cancelled.
SequenceReport checkSequence(const FrameSequence& sequence, FrameRange range, const Task& task = {});

/// A frame as it is shown, display-referred, over the background where it is transparent. Throws Error.
ColorImage readFrame(const std::filesystem::path& path, glm::vec3 background);

/// "3, 7-9" of ascending numbers.
std::string rangesText(const std::vector<int>& numbers);

}  // namespace chiaro::exporting
