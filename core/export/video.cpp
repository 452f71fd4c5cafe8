#include "core/export/video.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/module.h"
#include "core/export/video/encoder.h"
#include "core/export/video_container.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>

namespace chiaro::exporting {

namespace fs = std::filesystem;

namespace {

struct VideoFormat {
    const char* extension;
    std::array<const char*, 2> codes;  ///< of encoders, the better one first
};

constexpr std::array<VideoFormat, 3> formats{
    {{".mp4", {"avc1", "mp4v"}}, {".webm", {"VP90", "VP80"}}, {".mkv", {"FFV1", "FFV1"}}}};

const VideoFormat* formatOf(const fs::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    const auto found = std::ranges::find(formats, extension, &VideoFormat::extension);
    return found == formats.end() ? nullptr : &*found;
}

const VideoModule& videoModule() {
    static const VideoModule& module =
        *reinterpret_cast<const VideoModule* (*)()>(moduleFunction("chiaro_video", "chiaroVideoModule"))();
    return module;
}

int evenAbove(int side) {
    return side + side % 2;
}

}  // namespace

struct VideoWriter::Impl {
    fs::path path;
    AtomicFile file;
    int width, height;
    std::unique_ptr<VideoEncoder> encoder;
    std::vector<std::uint8_t> pixels;
    int frames = 0;

    Impl(const fs::path& destination, int pictureWidth, int pictureHeight, double framesPerSecond)
        : path(destination), file(destination), width(pictureWidth), height(pictureHeight) {
        for (const char* code : formatOf(path)->codes)
            if (!encoder)
                encoder = videoModule().open(file.temporaryPath(), code, evenAbove(width), evenAbove(height),
                                             framesPerSecond);
        if (!encoder)
            throw Error(
                path.string(),
                fmt::format("can't be written: there is no encoder for {} here", path.extension().string()),
                "choose .mp4, .webm or .mkv, or a sequence of pictures");
    }
};

VideoWriter::VideoWriter(const fs::path& path, int width, int height, double framesPerSecond) {
    if (!isWritableVideo(path))
        throw Error(path.string(), "has no extension of a video", "choose .mp4, .webm or .mkv");
    m_impl = std::make_unique<Impl>(path, width, height, framesPerSecond);
}
VideoWriter::~VideoWriter() = default;
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;

void VideoWriter::add(const ColorImage& picture) {
    const int width = evenAbove(m_impl->width), height = evenAbove(m_impl->height);
    m_impl->pixels.clear();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec3 color = picture(std::min(x, m_impl->width - 1), std::min(y, m_impl->height - 1));
            for (const int channel : {2, 1, 0})
                // As pictures are rounded, so that a video of frames is the video of what they were made
                // from.
                m_impl->pixels.push_back(
                    std::uint8_t(std::floor(double(std::clamp(color[channel], 0.0f, 1.0f)) * 255.0 + 0.5)));
        }
    m_impl->encoder->add(m_impl->pixels.data());
    ++m_impl->frames;
}

void VideoWriter::finish() {
    m_impl->encoder->close();
    const int found = videoModule().countFrames(m_impl->file.temporaryPath());
    if (found != m_impl->frames)
        throw Error(m_impl->path.string(),
                    fmt::format("could not be written (only {} of {} frames arrived)", found, m_impl->frames),
                    "choose a folder you may write to that has space left");
    if (!isWholeContainer(m_impl->file.temporaryPath()))
        throw Error(m_impl->path.string(), "could not be written (it was cut off)",
                    "choose a folder you may write to that has space left");
    m_impl->file.commit();
}

bool isWritableVideo(const fs::path& path) {
    return formatOf(path) != nullptr;
}

}  // namespace chiaro::exporting
