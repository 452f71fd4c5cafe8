#include "core/base/atomic_file.h"
#include "core/base/image_io.h"
#include "tests/cli/program.h"
#include "tests/support/support.h"

#include <opencv2/videoio.hpp>
#include <sys/mount.h>
#include <sys/resource.h>

#include <csignal>
#include <unistd.h>

namespace chiaro::test {
namespace {

const std::string oil = resource("demo/samples/oil.png").string();
const std::string skull = resource("demo/meshes/skull.glb").string();

/// animate with a small picture of the skull and further arguments.
Outcome animate(const std::string& output, const std::vector<std::string>& more,
                const std::string& size = "80x80") {
    std::vector<std::string> arguments{"animate",     "--mesh", skull,     "--sample", oil, "--method",
                                       "image-based", "--size", size,      "--every",  "4", "-o",
                                       output,        "--json", "--block", "16"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return chiaro(arguments);
}

std::string bytes(const std::filesystem::path& path) {
    return readFile(path, 1 << 24);
}

TEST(Animate, PartsOfAPathGiveTheFramesOfTheWhole) {
    for (const char* coherence : {"independent", "previous", "keyframes", "reprojected"}) {
        const TemporaryFolder whole, part;
        const Outcome outcome = animate(whole / "a.####.png", {"--frames", "1-7", "--coherence", coherence});
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_EQ(outcome.json()["frames"], 7);
        EXPECT_EQ(outcome.json()["resumed"], 0);
        EXPECT_GT(outcome.json()["seconds"], 0);
        ASSERT_EQ(filesIn(whole.path()).size(), 7u);
        ASSERT_EQ(
            animate(part / "a.####.png", {"--frames", "6-7", "--coherence", coherence, "--threads", "1"})
                .status,
            0);
        ASSERT_EQ(filesIn(part.path()).size(), 2u);
        for (const char* name : {"a.0006.png", "a.0007.png"})
            EXPECT_EQ(bytes(whole / name), bytes(part / name)) << coherence << " " << name;
    }
}

TEST(Animate, ResumeKeepsFinishedFramesOfTheSameCommandAlone) {
    const TemporaryFolder folder;
    const std::string output = folder / "a.####.png";
    ASSERT_EQ(animate(output, {"--frames", "1-4"}).status, 0);
    const std::string first = bytes(folder / "a.0001.png"), third = bytes(folder / "a.0003.png");
    std::filesystem::remove(folder / "a.0002.png");
    writeFileAtomically(folder / "a.0003.png", third.substr(0, third.size() / 2));  // cut off
    const auto written = std::filesystem::last_write_time(folder / "a.0001.png");
    const Outcome resumed = animate(output, {"--frames", "1-5", "--resume"});
    ASSERT_EQ(resumed.status, 0) << resumed.error;
    EXPECT_EQ(resumed.json()["resumed"], 2);
    EXPECT_EQ(std::filesystem::last_write_time(folder / "a.0001.png"), written);
    EXPECT_EQ(bytes(folder / "a.0003.png"), third);
    EXPECT_EQ(filesIn(folder.path()).size(), 5u);
    // Another tolerance makes other pictures.
    EXPECT_EQ(animate(output, {"--frames", "1-5", "--resume", "--tolerance", "0.4"}).json()["resumed"], 0);
    EXPECT_NE(bytes(folder / "a.0001.png"), first);
    EXPECT_EQ(animate(output, {"--frames", "1-5", "--resume", "--tolerance", "0.4", "--light", "1,0,0"})
                  .json()["resumed"],
              0);
}

TEST(Animate, WritesVideosAndTheValuesBehindEachFrame) {
    const TemporaryFolder folder;
    ASSERT_EQ(animate(folder / "a.mp4", {"--frames", "1-3"}).status, 0);
    EXPECT_GT(std::filesystem::file_size(folder / "a.mp4"), 500u);
    ASSERT_EQ(animate(folder / "a.####.png", {"--frames", "2-3", "--aux", folder / "aux"}).status, 0);
    for (const char* name : {"light.0002.exr", "id.0002.png", "depth.0003.exr", "normal.0003.exr",
                             "texture.0002.exr", "motion.0002.exr"})
        EXPECT_TRUE(std::filesystem::exists(folder / "aux" / name)) << name;
}

TEST(Animate, SaysThatItPadsAVideoOfOddSize) {
    const TemporaryFolder folder;
    const Outcome outcome = chiaro({"animate", "--mesh", skull, "--sample", oil, "--method", "image-based",
                                    "--size", "33x21", "--frames", "1-2", "-o", folder / "a.mkv"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_NE(outcome.out.find("padded to 34 x 22 px"), std::string::npos) << outcome.out;
}

TEST(Animate, ALightPathMovesTheLightAndAFileBoth) {
    const TemporaryFolder folder;
    ASSERT_EQ(animate(folder / "l.####.png", {"--frames", "1-2", "--path", "light", "--period", "4"}).status,
              0);
    EXPECT_NE(bytes(folder / "l.0001.png"), bytes(folder / "l.0002.png"));
    writeFileAtomically(folder / "p.json",
                        R"({"path": 1, "keys": [{"frame": 1, "azimuth": 30}, {"frame": 3, "azimuth": 60}]})");
    const Outcome outcome = animate(folder / "p.####.png", {"--frames", "1-4", "--path", folder / "p.json",
                                                            "--coherence", "independent"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    // Beyond the last key everything rests.
    EXPECT_EQ(readImage(folder / "p.0003.png").values, readImage(folder / "p.0004.png").values);
    EXPECT_NE(readImage(folder / "p.0002.png").values, readImage(folder / "p.0003.png").values);
}

TEST(Animate, APeriodThatNothingTurnsByIsRefused) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "p.json", R"({"path": 1, "keys": [{"frame": 1, "azimuth": 30}]})");
    for (const std::string& path : {std::string("approach"), (folder / "p.json").string()}) {
        const Outcome outcome =
            animate(folder / "a.####.png", {"--frames", "1-2", "--path", path, "--period", "4"});
        EXPECT_EQ(outcome.status, 2) << path;
        EXPECT_NE(outcome.error.find("--period"), std::string::npos) << outcome.error;
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "a.0001.png"));
}

TEST(Animate, FrameOneIsWhatRenderMakes) {
    const TemporaryFolder folder;
    for (const char* method : {"image-based", "view-aligned"}) {
        ASSERT_EQ(chiaro({"animate", "--mesh", skull, "--sample", oil, "--method", method, "--size", "60x60",
                          "--coherence", "independent", "--level-size", "64", "--frames", "1", "-o",
                          folder / "a.####.png", "--overwrite"})
                      .status,
                  0);
        ASSERT_EQ(chiaro({"render", "--mesh", skull, "--sample", oil, "--method", method, "--size", "60x60",
                          "--level-size", "64", "-o", folder / "r.png"})
                      .status,
                  0);
        EXPECT_EQ(readImage(folder / "a.0001.png").values, readImage(folder / "r.png").values) << method;
    }
}

TEST(Animate, RefusesWhatItCannotDoInOneSentence) {
    const TemporaryFolder folder;
    struct Case {
        std::string output;
        std::vector<std::string> more;
        int status;
        const char* says;
    };
    writeFileAtomically(folder / "p.json", "{}");
    for (const Case& one :
         std::vector<Case>{{folder / "a.png", {}, 2, "####"},
                           {folder / "a.####.gif", {}, 2, "####.gif"},
                           {folder / "a.####.png", {"--frames", "5-2"}, 2, "5-2"},
                           {folder / "a.####.png", {"--path", folder / "p.json"}, 1, "p.json"},
                           {folder / "a.####.png", {"--path", folder / "none.json"}, 1, "none.json"},
                           {folder / "a.####.png", {"--every", "0"}, 2, "--every"},
                           {folder / "a.mp4", {"--resume"}, 2, "--resume"},
                           {folder / "a.mp4", {"--aux", folder / "aux"}, 2, "--aux"},
                           {"/proc/none/a.####.png", {}, 1, "/proc/none/a.0001.png"},
                           {"/proc/none/a.mp4", {}, 1, "/proc/none/a.mp4"},
                           {folder / "a.mp4", {"--background", "transparent"}, 2, "transparent"}}) {
        const Outcome outcome = animate(one.output, one.more);
        EXPECT_EQ(outcome.status, one.status) << outcome.error;
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
        EXPECT_NE(outcome.error.find(one.says), std::string::npos) << outcome.error;
    }
    EXPECT_EQ(filesIn(folder.path()).size(), 1u);
}

TEST(Animate, ReplacesNothingUnasked) {
    const TemporaryFolder folder;
    for (const std::string name : {"a.####.png", "a.mkv"}) {
        const std::filesystem::path first = folder / (name == "a.mkv" ? name : "a.0002.png");
        writeFileAtomically(first, "mine");
        const Outcome refused = animate(folder / name, {"--frames", "1-2"});
        EXPECT_EQ(refused.status, 1);
        EXPECT_NE(refused.error.find(first.string() + ": is there already"), std::string::npos)
            << refused.error;
        EXPECT_NE(refused.error.find("--overwrite"), std::string::npos) << refused.error;
        EXPECT_EQ(refused.error.find("--resume") != std::string::npos, name != "a.mkv") << refused.error;
        EXPECT_EQ(bytes(first), "mine");
        EXPECT_EQ(filesIn(folder.path()).size(), 1u);
        EXPECT_EQ(animate(folder / name, {"--frames", "1-2", "--overwrite"}).status, 0);
        EXPECT_NE(bytes(first), "mine");
        for (const auto& file : filesIn(folder.path())) std::filesystem::remove(file);
    }
}

TEST(Animate, KilledAndResumedItGivesTheSameBytes) {
    const TemporaryFolder whole, killed;
    const auto inFolder = [&](const TemporaryFolder& folder) {
        return std::vector<std::string>{"animate",
                                        "--mesh",
                                        skull,
                                        "--sample",
                                        oil,
                                        "--method",
                                        "image-based",
                                        "--size",
                                        "120x120",
                                        "--every",
                                        "4",
                                        "--frames",
                                        "1-10",
                                        "--aux",
                                        folder / "aux",
                                        "-o",
                                        folder / "a.####.exr"};
    };
    ASSERT_EQ(chiaro(inFolder(whole)).status, 0);
    RunningChiaro run(inFolder(killed));
    for (int i = 0; i < 6000 && !std::filesystem::exists(killed / "a.0003.exr"); ++i) usleep(5000);
    run.signal(SIGKILL);
    EXPECT_EQ(run.wait().status, -1);
    EXPECT_TRUE(std::filesystem::exists(killed / "a.0003.exr"));
    EXPECT_FALSE(std::filesystem::exists(killed / "a.0010.exr")) << "was over before it was killed";
    writeFileAtomically(killed / (".a.0004.99999999-0-" + thisMachine() + ".exr"),
                        "what such a process may leave");
    std::vector<std::string> again = inFolder(killed);
    again.insert(again.end(), {"--resume", "--json"});
    const Outcome resumed = chiaro(again);
    ASSERT_EQ(resumed.status, 0) << resumed.error;
    EXPECT_GE(resumed.json()["resumed"], 3);
    for (const char* sub : {".", "aux"}) {
        const auto expected = filesIn(whole / sub), found = filesIn(killed / sub);
        ASSERT_EQ(found.size(), expected.size()) << sub;
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_EQ(bytes(found[i]), bytes(expected[i])) << found[i];
    }
}

/// A folder on a disk of 8 kB; where the user may make none, the test process is limited to files of 8 kB.
class SmallDisk {
public:
    SmallDisk() {
        if (mount("tmpfs", m_folder.path().c_str(), "tmpfs", 0, "size=8k") == 0) {
            m_isMounted = true;
            return;
        }
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit small{8192, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk() {
        if (m_isMounted)
            umount(m_folder.path().c_str());
        else
            setrlimit(RLIMIT_FSIZE, &m_before);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    const std::filesystem::path& path() const { return m_folder.path(); }

private:
    TemporaryFolder m_folder;
    bool m_isMounted = false;
    rlimit m_before{};
};

TEST(Animate, AFullDiskLeavesNothingHalfWritten) {
    const SmallDisk disk;
    for (const char* name : {"a.####.png", "a.####.exr", "a.####.tif", "a.mp4", "a.webm", "a.mkv"}) {
        const Outcome outcome =
            chiaro({"animate", "--mesh", skull, "--sample", oil, "--method", "view-aligned", "--level-size",
                    "64", "--size", "401x401", "--frames", "1-4", "-o", disk.path() / name});
        EXPECT_EQ(outcome.status, 1) << name;
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
        EXPECT_NE(outcome.error.find("could not be written"), std::string::npos) << outcome.error;
        EXPECT_NE(outcome.error.find("space left"), std::string::npos) << outcome.error;
        EXPECT_TRUE(filesIn(disk.path()).empty()) << name << " left " << filesIn(disk.path()).front();
        for (const auto& file : filesIn(disk.path())) std::filesystem::remove(file);
    }
}

TEST(Animate, VideosReopenWithTheirFramesSizeAndRate) {
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a.webm", "a.mkv"}) {
        const Outcome outcome = animate(folder / name, {"--frames", "1-5", "--fps", "12"}, "81x60");
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_EQ(outcome.error, "");
        cv::VideoCapture video((folder / name).string());
        EXPECT_EQ(int(video.get(cv::CAP_PROP_FRAME_WIDTH)), 82) << name;
        EXPECT_EQ(int(video.get(cv::CAP_PROP_FRAME_HEIGHT)), 60) << name;
        EXPECT_NEAR(video.get(cv::CAP_PROP_FPS), 12, 0.01) << name;
        int frames = 0;
        while (video.grab()) ++frames;
        EXPECT_EQ(frames, 5) << name;
    }
}

TEST(Animate, SequencesAreOfEveryFormatWithAndWithoutAlpha) {
    const TemporaryFolder folder;
    for (const std::string extension : {"png", "exr", "tif"})
        for (const std::string background : {"transparent", "#102030"}) {
            const std::string name = background == "transparent" ? "clear." : "opaque.";
            const Outcome outcome = animate(folder / (name + "####." + extension),
                                            {"--frames", "3-4", "--background", background});
            ASSERT_EQ(outcome.status, 0) << outcome.error;
            const DecodedImage picture = readImage(folder / (name + "0004." + extension));
            EXPECT_EQ(picture.channels, background == "transparent" ? 4 : 3) << name << extension;
            EXPECT_EQ(picture.width, 80);
            EXPECT_EQ(animate(folder / (name + "####." + extension),
                              {"--frames", "3-4", "--background", background, "--resume"})
                          .json()["resumed"],
                      2)
                << name << extension;
        }
}

TEST(Animate, AnInterruptedVideoLeavesNothing) {
    const TemporaryFolder folder;
    const Outcome outcome = interruptedChiaro(
        {"animate", "--mesh", skull, "--sample", oil, "--method", "image-based", "-o", folder / "a.mp4"},
        1500);
    EXPECT_EQ(outcome.status, 130) << outcome.error;
    EXPECT_TRUE(filesIn(folder.path()).empty());
}

}  // namespace
}  // namespace chiaro::test
