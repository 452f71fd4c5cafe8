#include "core/base/atomic_file.h"
#include "core/base/image_io.h"
#include "core/gradient/gradient.h"
#include "core/sample/strip.h"
#include "tests/cli/program.h"
#include "tests/support/support.h"

#include <fstream>

namespace chiaro::test {
namespace {

const std::string oil = resource("demo/samples/oil.png").string();
const std::string skull = resource("demo/meshes/skull.glb").string();

std::vector<std::vector<double>> rowsOf(const std::filesystem::path& csv) {
    std::ifstream stream(csv);
    std::string line;
    std::getline(stream, line);
    EXPECT_EQ(line, "x,r,g,b");
    std::vector<std::vector<double>> rows;
    while (std::getline(stream, line)) {
        std::stringstream cells(line);
        std::vector<double>& row = rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    }
    return rows;
}

/// One line on stderr that begins with the program's name and has a cause and a remedy.
void expectOneSentence(const Outcome& outcome) {
    EXPECT_TRUE(outcome.error.starts_with("chiaro: ")) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_NE(outcome.error.find("; "), std::string::npos) << outcome.error;
}

TEST(SampleInfo, TellsWhatTheContractNames) {
    const Outcome outcome =
        chiaro({"sample", "info", oil, "--json", "--import-memory", "1024", "--import-seconds", "60"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.json()["width"], 800);
    EXPECT_EQ(outcome.json()["height"], 200);
    EXPECT_EQ(outcome.json()["channels"], 3);
    EXPECT_GT(outcome.json()["kept"], 10);
    EXPECT_LT(outcome.json()["residue"].get<double>(), 0.1);
}

TEST(SampleGradient, WritesGradientAveragesAndOrder) {
    const TemporaryFolder folder;
    const Outcome outcome = chiaro({"sample", "gradient", oil, "-o", folder / "g.csv", "--match-speed", "off",
                                    "--averages", folder / "a.csv", "--order", folder / "k.csv"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto averages = rowsOf(folder / "a.csv");
    const auto order = rowsOf(folder / "k.csv");
    const auto gradient = rowsOf(folder / "g.csv");
    ASSERT_EQ(averages.size(), 800u);
    ASSERT_EQ(gradient.size(), 800u);
    EXPECT_EQ(order.front()[0], 0);
    EXPECT_EQ(order.back()[0], 799);
    for (const auto& row : order)
        for (std::size_t channel = 1; channel < 4; ++channel)
            EXPECT_NEAR(row[channel], averages[std::size_t(row[0])][channel], 1e-6);
    for (std::size_t x = 0; x < 800; x += 37) {  // stretching by linear interpolation, end on end
        const double at = double(x) / 799 * double(order.size() - 1);
        const std::size_t left = std::min(std::size_t(at), order.size() - 2);
        for (std::size_t channel = 1; channel < 4; ++channel)
            EXPECT_NEAR(gradient[x][channel],
                        order[left][channel] +
                            (at - double(left)) * (order[left + 1][channel] - order[left][channel]),
                        2e-6);
    }
}

TEST(SampleTexture, AddsUpToTheStrip) {
    const TemporaryFolder folder;
    ASSERT_EQ(chiaro({"sample", "texture", oil, "-o", folder / "d.exr"}).status, 0);
    ASSERT_EQ(chiaro({"sample", "gradient", oil, "-o", folder / "g.csv"}).status, 0);
    const DecodedImage texture = readImage(folder / "d.exr");
    const auto gradient = rowsOf(folder / "g.csv");
    const ColorImage strip = sample::makeStrip(sample::readScan(oil));
    ASSERT_EQ(texture.channels, 3);
    double worst = 0;
    for (int y = 0; y < strip.height(); ++y)
        for (int x = 0; x < strip.width(); ++x)
            for (int channel = 0; channel < 3; ++channel)
                worst = std::max(worst, std::abs(texture.values[std::size_t((y * 800 + x) * 3 + channel)] +
                                                 gradient[std::size_t(x)][std::size_t(channel) + 1] -
                                                 double(strip(x, y)[channel])));
    EXPECT_LT(worst, 1e-6);
}

TEST(SampleRecolor, WritesAPictureThatTellsWhatMadeIt) {
    const TemporaryFolder folder;
    const Outcome outcome = chiaro(
        {"sample", "recolor", oil, "--stops", "0 #201040, 0.5 #c04020, 1 #fff0b0", "-o", folder / "r.png"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(readImage(folder / "r.png").width, 800);
    const std::string bytes = readFile(folder / "r.png", 1 << 24);
    EXPECT_NE(bytes.find("#c04020"), std::string::npos);
    EXPECT_NE(bytes.find("Chiaro "), std::string::npos);
}

TEST(Levels, WritesTheStackAndASheet) {
    const TemporaryFolder folder;
    const Outcome outcome =
        chiaro({"levels", oil, "-o", folder / "l", "--count", "3", "--size", "96", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.json()["count"], 3);
    EXPECT_EQ(outcome.json()["size"], 96);
    EXPECT_GT(outcome.json()["overlap_error"].get<double>(), 0);
    EXPECT_EQ(readImage(folder / "l/level_2.exr").width, 96);
    EXPECT_FALSE(std::filesystem::exists(folder / "l/level_3.exr"));
    EXPECT_GT(readImage(folder / "l/sheet.png").width, 2 * 96);
}

TEST(Render, PaintsTheSkullTheSameOnOneThreadAndOnEight) {
    const TemporaryFolder folder;
    std::vector<std::string> pictures;
    for (const std::string threads : {"1", "8"}) {
        const std::filesystem::path picture = folder / (threads + ".png");
        const Outcome outcome = chiaro({"render", "--mesh", skull, "--sample", oil, "--size", "160x120", "-o",
                                        picture, "--threads", threads, "--json", "--aux", folder / threads});
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_EQ(outcome.json()["method"], "view-aligned");
        EXPECT_EQ(outcome.json()["width"], 160);
        EXPECT_EQ(outcome.json()["threads"], std::stoi(threads));
        EXPECT_GT(outcome.json()["pixels"], 160 * 120 / 5);
        pictures.push_back(readFile(picture, 1 << 24));
    }
    EXPECT_EQ(pictures[0], pictures[1]);
    const DecodedImage light = readImage(folder / "1/light.exr");
    EXPECT_EQ(light.channels, 1);
    EXPECT_EQ(light.values.front(), -1);
    const DecodedImage ids = readImage(folder / "1/id.png");
    EXPECT_EQ(ids.values.front(), 0);
    for (const char* name : {"depth.exr", "normal.exr", "texture.exr"})
        EXPECT_EQ(readImage(folder / "1" / name).width, 160) << name;
}

TEST(Render, ImageBasedIsTheSameOnOneThreadAndOnEight) {
    const TemporaryFolder folder;
    std::vector<std::string> pictures;
    for (const std::string threads : {"1", "8"}) {
        const std::filesystem::path picture = folder / (threads + ".png");
        const Outcome outcome =
            chiaro({"render", "--mesh", skull, "--sample", oil, "--method", "image-based", "--window", "2",
                    "--block", "24", "--size", "160x120", "-o", picture, "--threads", threads, "--json"});
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_EQ(outcome.json()["method"], "image-based");
        EXPECT_GT(outcome.json()["blocks"], 10);
        EXPECT_GT(outcome.json()["overlap_error"].get<double>(), 0);
        EXPECT_GT(outcome.json()["seconds"]["synthesis"].get<double>(), 0);
        pictures.push_back(readFile(picture, 1 << 24));
    }
    EXPECT_EQ(pictures[0], pictures[1]);
    EXPECT_NE(pictures[0].find("\"window\":2"), std::string::npos);
}

/// Two halves, dark and light, the right one object 2, and a column outside.
void writeGuide(const TemporaryFolder& folder) {
    ScalarImage light(40, 30, 0.25f);
    IdImage ids(40, 30, 1);
    for (int y = 0; y < 30; ++y) {
        for (int x = 20; x < 40; ++x) {
            light(x, y) = 0.75f;
            ids(x, y) = 2;
        }
        light(39, y) = std::nanf("");
    }
    writeImage(folder / "light.exr", light);
    writeImage(folder / "ids.png", ids);
}

TEST(Render, PaintsAnyGuideByItsObjects) {
    const TemporaryFolder folder;
    writeGuide(folder);
    const std::string hatching = resource("demo/samples/hatching.png").string();
    const Outcome outcome =
        chiaro({"render", "--guide", folder / "light.exr", "--ids", folder / "ids.png", "--sample", oil,
                "--object", "2=" + hatching, "--background", "transparent", "-o", folder / "a.png", "--json",
                "--aux", folder / "aux"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.json()["method"], "image-based");
    EXPECT_EQ(outcome.json()["width"], 40);
    EXPECT_EQ(outcome.json()["pixels"], 39 * 30);
    const DecodedImage picture = readImage(folder / "a.png");
    EXPECT_EQ(picture.values[39 * 4 + 3], 0) << "NaN is outside";
    for (std::size_t x = 20; x < 39; ++x)  // the hatching is grey, the oil isn't
        EXPECT_NEAR(picture.values[x * 4], picture.values[x * 4 + 2], 0.2) << x;
    EXPECT_FALSE(std::filesystem::exists(folder / "aux/depth.exr"));
    EXPECT_EQ(readImage(folder / "aux/id.png").values[25] * 255, 2);
    const Outcome unknown = chiaro({"render", "--guide", folder / "light.exr", "--sample", oil, "--object",
                                    "2=" + hatching, "-o", folder / "b.png"});
    EXPECT_EQ(unknown.status, 1);
    expectOneSentence(unknown);
    const Outcome sizes = chiaro({"render", "--guide", hatching, "--ids", folder / "ids.png", "--sample", oil,
                                  "-o", folder / "b.png"});
    EXPECT_EQ(sizes.status, 1);
    expectOneSentence(sizes);
    EXPECT_FALSE(std::filesystem::exists(folder / "b.png"));
}

TEST(Render, GuidesAreForImageBasedAlone) {
    const TemporaryFolder folder;
    writeGuide(folder);
    const std::string light = folder / "light.exr";
    for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
             {"--method", "view-aligned"}, {"--mesh", skull}, {"--size", "64x64"}, {"--camera", "0,0,1"}}) {
        std::vector<std::string> arguments{"render", "--guide", light,           "--sample",
                                           oil,      "-o",      folder / "a.png"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_EQ(chiaro(arguments).status, 2) << more.front();
    }
    EXPECT_EQ(
        chiaro({"render", "--mesh", skull, "--ids", light, "--sample", oil, "-o", folder / "a.png"}).status,
        2);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST(Render, EveryObjectMayWearItsOwnPaint) {
    const TemporaryFolder folder;
    const std::string hatching = resource("demo/samples/hatching.png").string();
    const Outcome outcome = chiaro({"render", "--mesh", skull, "--sample", oil, "--object", "jaw=" + hatching,
                                    "--size", "64x64", "-o", folder / "a.png"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    const Outcome unknown = chiaro({"render", "--mesh", skull, "--sample", oil, "--object",
                                    "nose=" + hatching, "--size", "64x64", "-o", folder / "b.png"});
    EXPECT_EQ(unknown.status, 1);
    expectOneSentence(unknown);
    EXPECT_NE(unknown.error.find("\"jaw\""), std::string::npos) << unknown.error;
}

TEST(Usage, IsRefusedWithStatus2) {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {},
             {"paint"},
             {"sample", "info"},
             {"levels", oil, "-o", folder / "l", "--count", "1"},
             {"levels", oil, "-o", folder / "l", "--block", "x"},
             {"levels", oil, "-o", folder / "l", "--seed", "-1"},
             {"sample", "info", oil, "--seed", "-1"},
             {"sample", "info", oil, "--import-memory", "100"},
             {"sample", "info", oil, "--import-seconds", "0"},
             {"sample", "recolor", oil, "--stops", "0 #12345", "-o", folder / "r.png"},
             {"render", "--mesh", skull, "-o", folder / "a.png"},
             {"render", "--mesh", skull, "--sample", oil, "--size", "16384x16384", "-o", folder / "a.png"},
             {"render", "--mesh", skull, "--sample", oil, "--size", "0x10", "-o", folder / "a.png"},
             {"render", "--mesh", skull, "--sample", oil, "--light", "0,0,0", "-o", folder / "a.png"},
             {"render", "--mesh", skull, "--sample", oil, "--camera", "0,91,1", "-o", folder / "a.png"},
             {"render", "--mesh", skull, "--sample", oil, "--method", "guess", "-o", folder / "a.png"}}) {
        const Outcome outcome = chiaro(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome.error;
        EXPECT_TRUE(outcome.error.starts_with("chiaro: ")) << outcome.error;
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    }
    EXPECT_TRUE(filesIn(folder.path()).empty());
}

TEST(BadInput, IsOneSentenceStatus1AndNoOutput) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "empty.png", "");
    writeFileAtomically(folder / "empty.obj", "");
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"sample", "info", folder / "missing.png"},
             {"sample", "gradient", folder / "empty.png", "-o", folder / "out/g.csv"},
             {"sample", "texture", oil, "-o", folder / "out/d.png"},
             {"sample", "recolor", oil, "--stops", "0 #123456", "-o", folder / "out/r.doc"},
             {"levels", folder / "empty.png", "-o", folder / "out"},
             {"render", "--mesh", folder / "empty.obj", "--sample", oil, "-o", folder / "out/a.png"},
             {"render", "--mesh", skull, "--sample", folder / "empty.png", "-o", folder / "out/a.png"},
             {"render", folder / "missing.chiaro", "-o", folder / "out/a.png"},
             {"render", "--mesh", skull, "--sample", oil, "-o", folder / "out/a.doc"}}) {
        const Outcome outcome = chiaro(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments.back() << outcome.error;
        expectOneSentence(outcome);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(BadInput, AnInputIsNeverOverwritten) {
    const TemporaryFolder folder;
    const std::filesystem::path strip = folder / "strip.png";
    std::filesystem::copy_file(oil, strip);
    const std::string before = readFile(strip, 1 << 24);
    std::filesystem::create_directory(folder / "sub");
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"sample", "gradient", strip, "-o", strip},
             {"sample", "gradient", strip, "-o", folder / "sub/../strip.png"},
             {"sample", "gradient", strip, "-o", folder / "g.csv", "--averages", folder / "g.csv"},
             {"sample", "recolor", strip, "--stops", "0 #000000, 1 #ffffff", "-o", strip},
             {"render", "--mesh", skull, "--sample", strip, "-o", strip}}) {
        const Outcome outcome = chiaro(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments[1];
        expectOneSentence(outcome);
    }
    EXPECT_EQ(readFile(strip, 1 << 24), before);
    std::filesystem::permissions(strip, std::filesystem::perms::owner_read);
    const Outcome outcome =
        chiaro({"sample", "recolor", oil, "--stops", "0 #000000, 1 #ffffff", "-o", strip});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.error.find("read-only"), std::string::npos) << outcome.error;
    EXPECT_EQ(readFile(strip, 1 << 24), before);
}

TEST(BadInput, ASampleThatIsTooSmallIsNamed) {
    const TemporaryFolder folder;
    writeImage(folder / "dot.png", ColorImage(1, 1));
    const Outcome outcome = chiaro({"sample", "info", folder / "dot.png"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.error.find("dot.png"), std::string::npos) << outcome.error;
}

TEST(BadInput, RealBrokenFilesNeverCrashTheProgram) {
    CHIARO_NEEDS_SHARED_DATA();
    const TemporaryFolder folder;
    for (const auto& picture : filesIn(sharedData() / "broken/images")) {
        const Outcome outcome = chiaro({"sample", "texture", picture, "-o", folder / "out.exr", "--quiet"});
        EXPECT_TRUE(outcome.status == 0 || outcome.status == 1) << picture << outcome.status;
        if (outcome.status == 1) expectOneSentence(outcome);
        EXPECT_EQ(std::filesystem::remove(folder / "out.exr"), outcome.status == 0) << picture;
    }
    for (const auto& mesh : filesIn(sharedData() / "broken/meshes")) {
        const Outcome outcome = chiaro({"render", "--mesh", mesh, "--sample", oil, "--size", "64x64", "-o",
                                        folder / "out.png", "--quiet"});
        EXPECT_TRUE(outcome.status == 0 || outcome.status == 1) << mesh << outcome.status;
        if (outcome.status == 1) expectOneSentence(outcome);
        EXPECT_EQ(std::filesystem::remove(folder / "out.png"), outcome.status == 0) << mesh;
    }
}

TEST(Interrupt, EndsWith130AndLeavesNothing) {
    const TemporaryFolder folder;
    const Outcome outcome = interruptedChiaro(
        {"levels", oil, "-o", folder / "l", "--count", "32", "--size", "2048", "--block", "16"}, 600);
    EXPECT_EQ(outcome.status, 130) << outcome.error;
    EXPECT_FALSE(std::filesystem::exists(folder / "l"));
}

TEST(Help, NamesUnitsRangesAndDefaults) {
    const Outcome outcome = chiaro({"levels", "--help"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.out.find("64..2048 px; default 512"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("mask or seam; default seam"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace chiaro::test
