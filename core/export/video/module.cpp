#include "core/export/video/encoder.h"

#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>

namespace chiaro::exporting {

namespace {

/// Keeps what the libraries print on their own from stderr, where a program's one sentence belongs: FFmpeg's
/// messages from here on, and OpenCV's remarks on codec tags while this lasts.
class Hush {
public:
    Hush() : m_kept(::dup(STDERR_FILENO)) {
        constexpr const char* nothing = "-8";
        ::setenv("OPENCV_FFMPEG_LOGLEVEL", nothing, 0);
        const int silence = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (m_kept >= 0 && silence >= 0) ::dup2(silence, STDERR_FILENO);
        if (silence >= 0) ::close(silence);
    }
    ~Hush() {
        if (m_kept < 0) return;
        ::dup2(m_kept, STDERR_FILENO);
        ::close(m_kept);
    }
    Hush(const Hush&) = delete;
    Hush& operator=(const Hush&) = delete;

private:
    int m_kept;
};

class OpenCvEncoder : public VideoEncoder {
public:
    OpenCvEncoder(const std::filesystem::path& path, const char* code, int width, int height,
                  double framesPerSecond)
        : m_width(width), m_height(height) {
        m_writer.open(path.string(), cv::CAP_FFMPEG,
                      cv::VideoWriter::fourcc(code[0], code[1], code[2], code[3]), framesPerSecond,
                      cv::Size(width, height));
    }

    bool isOpen() const { return m_writer.isOpened(); }

    void add(const std::uint8_t* pixels) override {
        // A view of pixels that the writer only reads.
        m_writer.write(cv::Mat(m_height, m_width, CV_8UC3, const_cast<std::uint8_t*>(pixels)));
    }

    void close() override { m_writer.release(); }

private:
    cv::VideoWriter m_writer;
    int m_width;
    int m_height;
};

std::unique_ptr<VideoEncoder> open(const std::filesystem::path& path, const char* code, int width, int height,
                                   double framesPerSecond) {
    const Hush hush;
    auto encoder = std::make_unique<OpenCvEncoder>(path, code, width, height, framesPerSecond);
    return encoder->isOpen() ? std::move(encoder) : nullptr;
}

int countFrames(const std::filesystem::path& path) {
    const Hush hush;
    cv::VideoCapture capture(path.string(), cv::CAP_FFMPEG);
    int frames = 0;
    while (capture.grab()) ++frames;
    return frames;
}

}  // namespace

}  // namespace chiaro::exporting

extern "C" const chiaro::exporting::VideoModule* chiaroVideoModule() {
    static constexpr chiaro::exporting::VideoModule module{chiaro::exporting::open,
                                                           chiaro::exporting::countFrames};
    return &module;
}
