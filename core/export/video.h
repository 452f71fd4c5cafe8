#pragma once

#include "core/base/image.h"

#include <filesystem>
#include <memory>

namespace chiaro::exporting {

/// A video in the making. It appears whole or not at all; destroyed unfinished it leaves nothing behind.
class VideoWriter {
public:
    /// The extension decides the format: .mp4 is H.264, .webm VP9, .mkv FFV1 (lossless). Sides of an odd
    /// number of pixels get one more, a repetition of the last. Throws Error when the extension is another
    /// one or the format can't be written on this machine.
    VideoWriter(const std::filesystem::path& path, int width, int height, double framesPerSecond);
    ~VideoWriter();
    VideoWriter(VideoWriter&&) noexcept;
    VideoWriter& operator=(VideoWriter&&) noexcept;

    /// The next frame, of the video's size, display-referred in [0, 1]. Throws Error.
    void add(const ColorImage& picture);
    /// Ends the file, reads it again and counts its frames. Throws Error.
    void finish();

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// True for a path whose extension VideoWriter takes.
bool isWritableVideo(const std::filesystem::path& path);

}  // namespace chiaro::exporting
