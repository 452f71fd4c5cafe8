#include "core/base/atomic_file.h"
#include "core/base/image_io.h"
#include "tests/cli/program.h"
#include "tests/support/support.h"

#include <fstream>

namespace chiaro::test {
namespace {

const std::string oil = resource("demo/samples/oil.png").string();
const std::string skull = resource("demo/meshes/skull.glb").string();

/// animate with a small picture of the skull and further arguments.
Outcome animate(const std::string& output, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"animate",     "--mesh", skull,     "--sample", oil, "--method",
                                       "image-based", "--size", "80x80",   "--every",  "4", "-o",
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
                          folder / "a.####.png"})
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
                           {folder / "a.mp4", {"--background", "transparent"}, 2, "transparent"}}) {
        const Outcome outcome = animate(one.output, one.more);
        EXPECT_EQ(outcome.status, one.status) << outcome.error;
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
        EXPECT_NE(outcome.error.find(one.says), std::string::npos) << outcome.error;
    }
    EXPECT_EQ(filesIn(folder.path()).size(), 1u);
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
