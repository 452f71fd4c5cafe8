#include "core/base/atomic_file.h"
#include "tests/cli/program.h"
#include "tests/cli/slurm_cluster.h"

#include <opencv2/videoio.hpp>

#include <csignal>
#include <fstream>
#include <unistd.h>

namespace chiaro::test {
namespace {

namespace fs = std::filesystem;

const std::string oil = resource("demo/samples/oil.png").string();
const std::string skull = resource("demo/meshes/skull.glb").string();

/// What animate is told, but for where its frames go.
const std::vector<std::string> shot{"--mesh", skull,     "--sample", oil, "--method", "image-based",
                                    "--size", "120x120", "--every",  "4", "--light",  "-1,1,1"};

std::vector<std::string> words(std::vector<std::string> first, const std::vector<std::string>& rest) {
    first.insert(first.end(), rest.begin(), rest.end());
    return first;
}

std::string bytes(const fs::path& path) {
    return readFile(path, 1 << 24);
}

void expectSameFrames(const fs::path& found, const fs::path& expected, std::size_t count) {
    const auto frames = filesIn(found), whole = filesIn(expected);
    ASSERT_EQ(whole.size(), count);
    ASSERT_EQ(frames.size(), count);
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(bytes(frames[i]), bytes(whole[i])) << frames[i];
}

/// Once this file is there, kills the process whose command line holds all of these words, unless that takes
/// longer than a minute. Slurm and bash name them too, so that it must be chiaro itself.
bool killChiaroAfter(const fs::path& written, const std::vector<std::string>& wanted) {
    for (int i = 0; i < 12'000; ++i, usleep(5000)) {
        if (!fs::exists(written)) continue;
        for (const auto& entry : fs::directory_iterator("/proc")) {
            const std::string process = entry.path().filename().string();
            if (process.find_first_not_of("0123456789") != std::string::npos) continue;
            std::ifstream stream(entry.path() / "cmdline");
            std::string line((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
            if (!line.starts_with(CHIARO_PROGRAM)) continue;
            const auto isIn = [&](const std::string& word) { return line.find(word) != std::string::npos; };
            if (std::ranges::all_of(wanted, isIn)) return kill(std::stoi(process), SIGKILL) == 0;
        }
    }
    return false;
}

class Farm : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_whole = std::make_unique<TemporaryFolder>();
        ASSERT_EQ(chiaro(words({"animate", "-o", *s_whole / "a.####.png", "--frames", "1-16"}, shot)).status,
                  0);
    }
    static void TearDownTestSuite() { s_whole.reset(); }

    std::vector<std::string> submit(const std::vector<std::string>& more) const {
        return words(words({"farm", "submit", "-o", pattern(), "--job", folder / "job", "--json"}, shot),
                     more);
    }
    std::string pattern() const { return folder / "frames/a.####.png"; }

    TemporaryFolder folder;
    static std::unique_ptr<TemporaryFolder> s_whole;
};
std::unique_ptr<TemporaryFolder> Farm::s_whole;

TEST_F(Farm, ChunksBeginAtKeyframesAndADryRunWritesNothing) {
    const Outcome dry = chiaro(
        submit({"--frames", "3-30", "--chunk", "10", "--dry-run", "--engine-option=--partition=long"}));
    ASSERT_EQ(dry.status, 0) << dry.error;
    std::vector<std::string> frames;
    const nlohmann::json told = dry.json();
    for (const auto& chunk : told["chunks"]) frames.push_back(chunk["frames"]);
    EXPECT_EQ(frames, (std::vector<std::string>{"3-12", "13-24", "25-30"}));  // keyframes: 1, 5, 9, 13, ..
    EXPECT_NE(told["chunks"][1]["command"].get<std::string>().find("--frames=13-24"), std::string::npos);
    std::vector<std::string> plain =
        submit({"--frames", "3-30", "--dry-run", "--engine-option=--partition=long"});
    std::erase(plain, "--json");
    const Outcome text = chiaro(plain);
    for (const char* said : {"#SBATCH --array=1-2\n", "#SBATCH --partition=long\n", "#SBATCH --requeue\n",
                             "--light=-1,1,1", "frames=( 3-24 25-30 )"})
        EXPECT_NE(text.out.find(said), std::string::npos) << said << " in\n" << text.out;
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST_F(Farm, FramesThatBuildOnTheOneBeforeAreNotTornApart) {
    const Outcome dry = chiaro(submit({"--frames", "1-30", "--coherence", "previous", "--dry-run"}));
    EXPECT_EQ(dry.json()["chunks"].size(), 1u);
    const Outcome apart =
        chiaro(submit({"--frames", "1-30", "--coherence", "independent", "--chunk", "7", "--dry-run"}));
    EXPECT_EQ(apart.json()["chunks"].size(), 5u);
}

TEST_F(Farm, ALocalChunkThatIsKilledIsBegunAgainAndTheWholeIsTheSame) {
    RunningChiaro run(submit({"--engine", "local", "--frames", "1-16", "--chunk", "8", "--at-most", "2"}));
    ASSERT_TRUE(killChiaroAfter(folder / "frames/a.0010.png", {"animate", pattern(), "--frames=9-16"}));
    const Outcome done = run.wait();
    ASSERT_EQ(done.status, 0) << done.error;
    expectSameFrames(folder / "frames", s_whole->path(), 16);
    const Outcome status = chiaro({"farm", "status", folder / "job", "--json"});
    ASSERT_EQ(status.status, 0) << status.error;
    EXPECT_EQ(status.json()["finished"], 16);
    EXPECT_EQ(status.json()["chunks"][0]["state"], "done");
    EXPECT_EQ(status.json()["chunks"][0]["tries"], 1);
    EXPECT_EQ(status.json()["chunks"][1]["state"], "done");
    EXPECT_EQ(status.json()["chunks"][1]["tries"], 2);
    // Again: refused, since the frames are there, and with --resume nothing is made twice.
    const std::vector<std::string> again = submit({"--engine", "local", "--frames", "1-16"});
    const Outcome refused = chiaro(again);
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.error.find("--resume"), std::string::npos) << refused.error;
    const auto written = fs::last_write_time(folder / "frames/a.0007.png");
    EXPECT_EQ(chiaro(words(again, {"--resume"})).status, 0);
    EXPECT_EQ(fs::last_write_time(folder / "frames/a.0007.png"), written);
}

TEST_F(Farm, AChunkThatAlwaysFailsIsSaidWithItsLog) {
    const std::string strip = folder / "strip.png";
    fs::copy_file(oil, strip);
    std::vector<std::string> arguments =
        submit({"--engine", "local", "--frames", "1-16", "--chunk", "8", "--tries", "2"});
    std::ranges::replace(arguments, oil, strip);
    writeFileAtomically(strip, bytes(oil).substr(0, 3000));  // found broken by the chunks
    const Outcome failed = chiaro(arguments);
    EXPECT_EQ(failed.status, 1);
    EXPECT_NE(failed.error.find("logs/1.log"), std::string::npos) << failed.error;
    const Outcome status = chiaro({"farm", "status", folder / "job", "--json"});
    EXPECT_EQ(status.json()["failed"], 2);
    EXPECT_EQ(status.json()["chunks"][0]["tries"], 2);
    EXPECT_NE(bytes(folder / "job/logs/1.log").find(strip), std::string::npos);
    EXPECT_EQ(chiaro({"farm", "status", folder / "job", "--wait"}).status, 1);
}

TEST_F(Farm, CollectFindsWhatIsMissingDamagedAndOfAnotherCommand) {
    fs::copy(s_whole->path(), folder / "frames");
    const std::vector<std::string> collect{"farm", "collect", pattern(), "--frames", "1-16"};
    EXPECT_EQ(chiaro(collect).status, 0);
    for (const char* name : {"a.0002.png", "a.0003.png", "a.0007.png"}) fs::remove(folder / "frames" / name);
    writeFileAtomically(folder / "frames/a.0009.png", bytes(*s_whole / "a.0009.png").substr(0, 4000));
    ASSERT_EQ(
        chiaro(
            words({"animate", "-o", pattern(), "--frames", "12", "--overwrite", "--tolerance", "0.4"}, shot))
            .status,
        0);
    const Outcome wrong = chiaro(collect);
    EXPECT_EQ(wrong.status, 1);
    for (const char* said :
         {"frames 2-3, 7 are missing", "frame 9 is damaged", "frame 12 is of another command"})
        EXPECT_NE(wrong.error.find(said), std::string::npos) << wrong.error;
    EXPECT_EQ(chiaro(words(collect, {"--video", folder / "a.mkv"})).status, 1);
    EXPECT_FALSE(fs::exists(folder / "a.mkv"));
}

TEST_F(Farm, TheVideoOfTheFramesIsTheVideoThatAnimateMakes) {
    ASSERT_EQ(chiaro(words({"animate", "-o", folder / "direct.mkv", "--frames", "1-4"}, shot)).status, 0);
    ASSERT_EQ(chiaro({"farm", "collect", *s_whole / "a.####.png", "--frames", "1-4", "--video",
                      folder / "collected.mkv"})
                  .status,
              0);
    cv::VideoCapture direct((folder / "direct.mkv").string()), collected((folder / "collected.mkv").string());
    cv::Mat a, b;
    int frames = 0;
    while (direct.read(a) && collected.read(b)) {
        ++frames;
        EXPECT_EQ(cv::norm(a, b, cv::NORM_INF), 0);
    }
    EXPECT_EQ(frames, 4);
    EXPECT_EQ(collected.get(cv::CAP_PROP_FPS), direct.get(cv::CAP_PROP_FPS));
}

TEST_F(Farm, OnSlurmAKilledTaskIsRequeuedAndTheWholeIsTheSame) {
    const SlurmCluster slurm;
    if (!slurm.problem().empty()) GTEST_SKIP() << "Slurm can't be started here: " << slurm.problem();
    const Outcome submitted = chiaro(submit({"--frames", "1-16", "--chunk", "8", "--threads", "1"}));
    ASSERT_EQ(submitted.status, 0) << submitted.error;
    const std::string number = submitted.json()["job"];
    ASSERT_TRUE(killChiaroAfter(folder / "frames/a.0002.png", {"animate", pattern(), "--frames=1-8"}));
    const Outcome status = chiaro({"farm", "status", number, "--wait", "--json"});
    ASSERT_EQ(status.status, 0) << status.error << status.out;
    EXPECT_EQ(status.json()["finished"], 16);
    EXPECT_EQ(status.json()["chunks"][0]["tries"], 2);
    EXPECT_EQ(status.json()["chunks"][1]["tries"], 1);
    EXPECT_EQ(chiaro({"farm", "collect", number}).status, 0);
    expectSameFrames(folder / "frames", s_whole->path(), 16);
}

TEST_F(Farm, RefusesWhatItCannotDoInOneSentence) {
    struct Case {
        std::vector<std::string> arguments;
        int status;
        const char* says;
    };
    const std::string frames = pattern();
    for (const Case& one : std::vector<Case>{
             {words({"farm", "submit", "-o", folder / "a.mp4"}, shot), 2, "--video"},
             {submit({"--engine", "none"}), 2, "--engine"},
             {submit({"--chunk", "0"}), 2, "--chunk"},
             {submit({"--frames", "9-2"}), 2, "9-2"},
             {{"farm", "status", folder.path()}, 1, "job.json"},
             {{"farm", "status", "nowhere"}, 1, "nowhere"},
             {{"farm", "collect", frames}, 1, "job.json"},
             {{"farm", "collect", frames, "--frames", "1-2", "--video", "a.gif"}, 2, "no video"}}) {
        const Outcome outcome = chiaro(one.arguments);
        EXPECT_EQ(outcome.status, one.status) << outcome.error;
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
        EXPECT_NE(outcome.error.find(one.says), std::string::npos) << outcome.error;
    }
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace chiaro::test
