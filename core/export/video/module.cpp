#include "core/export/video/encoder.h"

#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

namespace chiaro::exporting {

namespace {

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
    auto encoder = std::make_unique<OpenCvEncoder>(path, code, width, height, framesPerSecond);
    return encoder->isOpen() ? std::move(encoder) : nullptr;
}

int countFrames(const std::filesystem::path& path) {
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
