#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

namespace chiaro::exporting {

/// A video file that is written frame by frame; what stands behind it is loaded with the first one.
class VideoEncoder {
public:
    virtual ~VideoEncoder() = default;
    /// width * height pixels of blue, green, red, row after row.
    virtual void add(const std::uint8_t* pixels) = 0;
    virtual void close() = 0;
};

/// What the module offers.
struct VideoModule {
    /// Null when the machine has no encoder for this code of four letters. Both sides are even.
    std::unique_ptr<VideoEncoder> (*open)(const std::filesystem::path& path, const char* code, int width,
                                          int height, double framesPerSecond);
    /// How many frames can be read from a file.
    int (*countFrames)(const std::filesystem::path& path);
};

}  // namespace chiaro::exporting
