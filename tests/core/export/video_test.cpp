#include "core/export/video.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/export/video_container.h"
#include "tests/support/support.h"

#include <opencv2/videoio.hpp>

namespace chiaro::exporting {
namespace {

/// A frame whose left half is dark blue and whose right half lightens with its number.
ColorImage frame(int width, int height, int number) {
    ColorImage picture(width, height, glm::vec3(0.1f, 0.2f, 0.6f));
    for (int y = 0; y < height; ++y)
        for (int x = width / 2; x < width; ++x) picture(x, y) = glm::vec3(float(number) / 10);
    return picture;
}

class Formats : public testing::TestWithParam<const char*> {};

TEST_P(Formats, HoldTheFramesTheyWereGiven) {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder / (std::string("a") + GetParam());
    VideoWriter video(path, 97, 63, 24);
    for (int i = 0; i < 10; ++i) video.add(frame(97, 63, i));
    EXPECT_FALSE(std::filesystem::exists(path));
    video.finish();
    cv::VideoCapture capture(path.string());
    cv::Mat pixels;
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(capture.read(pixels)) << i;
        EXPECT_EQ(pixels.size(), cv::Size(98, 64));
        const auto left = pixels.at<cv::Vec3b>(30, 20), right = pixels.at<cv::Vec3b>(30, 75);
        EXPECT_NEAR(left[0], 153, 8);  // blue
        EXPECT_NEAR(left[2], 25, 8);   // red
        EXPECT_NEAR(right[1], i * 25.5, 8);
    }
    EXPECT_FALSE(capture.read(pixels));
    EXPECT_EQ(test::filesIn(folder.path()).size(), 1u);
}

TEST_P(Formats, AreKnownToBeCutOff) {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder / (std::string("a") + GetParam());
    VideoWriter video(path, 64, 64, 24);
    for (int i = 0; i < 6; ++i) video.add(frame(64, 64, i));
    video.finish();
    EXPECT_TRUE(isWholeContainer(path));
    const std::string whole = readFile(path, 1 << 24);
    for (const std::size_t missing : {std::size_t(1), std::size_t(7), whole.size() / 2, whole.size() - 5}) {
        writeFileAtomically(path, std::string_view(whole).substr(0, whole.size() - missing));
        EXPECT_FALSE(isWholeContainer(path)) << missing;
    }
    writeFileAtomically(path, whole + "x");
    EXPECT_FALSE(isWholeContainer(path));
    EXPECT_FALSE(isWholeContainer(folder / "none.mp4"));
}

INSTANTIATE_TEST_SUITE_P(All, Formats, testing::Values(".mp4", ".webm", ".mkv"));

TEST(Video, UnfinishedLeavesNothing) {
    const test::TemporaryFolder folder;
    {
        VideoWriter video(folder / "a.mp4", 32, 32, 24);
        video.add(frame(32, 32, 3));
    }
    EXPECT_TRUE(test::filesIn(folder.path()).empty());
}

TEST(Video, RefusesOtherExtensions) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(VideoWriter(folder / "a.gif", 32, 32, 24), Error);
    EXPECT_TRUE(isWritableVideo("a.MP4"));
    EXPECT_FALSE(isWritableVideo("a.png"));
}

}  // namespace
}  // namespace chiaro::exporting
