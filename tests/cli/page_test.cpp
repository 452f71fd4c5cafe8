#include "core/base/atomic_file.h"
#include "core/base/image_io.h"
#include "core/base/resources.h"
#include "core/gradient/color_presets.h"
#include "core/project/path_json.h"
#include "core/project/project.h"
#include "tests/cli/program.h"
#include "tests/support/support.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <fstream>

namespace chiaro::test {
namespace {

namespace fs = std::filesystem;
using scene::Light;

constexpr int side = 420;  // px, of all pictures

/// A skull in two paints and three lights of different kinds, made quickly.
project::Project skullInThreeLights() {
    project::Project project;
    project.meshes = {{resource("demo/meshes/skull.glb")}};
    for (const char* name : {"oil", "charcoal"}) {
        project::Sample& sample = project.samples.emplace_back();
        sample.name = name;
        sample.scan = resource(fmt::format("demo/samples/{}.png", name));
    }
    project.objects = {{.name = "jaw", .sample = 1}};
    project.lights = {
        {.kind = Light::Kind::Directional, .vector = {-0.5f, 0.6f, 0.7f}, .intensity = 0.7f},
        {.kind = Light::Kind::Directional, .vector = {1, 0.2f, 0}, .intensity = 0.3f, .wrap = false},
        {.kind = Light::Kind::Point, .vector = {0, 3, 1}, .intensity = 0.2f}};
    project.camera.azimuth = 28;
    project.camera.elevation = 6;
    project.levels.count = 4;
    project.levels.size = 128;
    project.views.count = 6;
    project.views.size = 256;
    return project;
}

/// A program on the PATH; empty when there is none.
fs::path programNamed(const std::string& name) {
    std::istringstream folders(std::getenv("PATH"));
    for (std::string folder; std::getline(folders, folder, ':');)
        if (fs::exists(fs::path(folder) / name)) return fs::path(folder) / name;
    return {};
}

std::string quoted(const std::string& argument) {
    std::string inside;
    for (const char c : argument) inside.append(c == '\'' ? "'\\''" : std::string(1, c));
    return fmt::format("'{}'", inside);
}

/// Pictures of a page, as tests/tools/page_shots.js makes them, and what that tells.
nlohmann::json shoot(const fs::path& page, const fs::path& folder, nlohmann::json shots) {
    for (nlohmann::json& shot : shots) shot.update({{"width", side}, {"height", side}});
    const fs::path out = folder / "shots.json";
    std::string command = quoted(programNamed("node"));
    for (const std::string& argument :
         {std::string(CHIARO_TEST_TOOLS "/page_shots.js"), std::string(CHIARO_NODE_MODULES),
          programNamed("chromium").string(), page.string(), folder.string(), shots.dump()})
        command += fmt::format(" {}", quoted(argument));
    if (std::system(fmt::format("{} > {}", command, quoted(out)).c_str()) != 0) return nullptr;
    return nlohmann::json::parse(readFile(out, 1 << 20));
}

/// Mean difference in steps of 1/255 where an object is, a pixel from its outline.
double differenceInside(const fs::path& shown, const fs::path& expected, const fs::path& ids) {
    const DecodedImage a = readImage(shown), b = readImage(expected), id = readImage(ids);
    EXPECT_EQ(a.width, side);
    EXPECT_EQ(a.height, side);
    const auto covered = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < side && y < side && id.values[std::size_t(y * side + x)] > 0;
    };
    double sum = 0, count = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            bool inside = true;
            for (int k = 0; k < 9; ++k) inside &= covered(x + k % 3 - 1, y + k / 3 - 1);
            if (!inside) continue;
            for (int c = 0; c < 3; ++c) {
                const std::size_t pixel = std::size_t(y * side + x);
                sum += std::abs(a.values[pixel * std::size_t(a.channels) + std::size_t(c)] -
                                b.values[pixel * std::size_t(b.channels) + std::size_t(c)]);
                ++count;
            }
        }
    EXPECT_GT(count, 3 * side * side / 10);
    return sum / count * 255;
}

/// What a page's address says of a key.
std::vector<float> numbersIn(const std::string& hash, const std::string& key) {
    std::istringstream text(hash.substr(hash.find(fmt::format("{}=", key)) + key.size() + 1));
    std::vector<float> numbers(1);
    while (text >> numbers.back() && text.get() == ',') numbers.emplace_back();
    return numbers;
}

class Page : public ::testing::Test {
protected:
    fs::path page() const { return folder / "page.html"; }

    void save(const project::Project& project) const { writeProject(folder / "skull.chiaro", project); }

    Outcome exportPage(std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"export", folder / "skull.chiaro", "-o", page(), "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return chiaro(arguments);
    }

    /// How much a shot differs from core's picture of a project.
    double difference(const std::string& shot, const project::Project& project, const std::string& method,
                      const fs::path& path = {}) const {
        save(project);
        const std::string size = fmt::format("{}x{}", side, side);
        std::vector<std::string> arguments{"render", folder / "skull.chiaro", "-o", folder / "core.png"};
        fs::path picture = folder / "core.png", ids = folder / "aux/id.png";
        if (!path.empty()) {
            arguments = {"animate",  folder / "skull.chiaro",
                         "-o",       folder / "core.####.png",
                         "--frames", "2-2",
                         "--path",   path};
            picture = folder / "core.0002.png";
            ids = folder / "aux/id.0002.png";
        }
        for (const std::string& more :
             {std::string("--method"), method, std::string("--size"), size, std::string("--background"),
              std::string("#000000"), std::string("--aux"), (folder / "aux").string()})
            arguments.push_back(more);
        const Outcome outcome = chiaro(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return differenceInside(folder / fmt::format("{}.png", shot), picture, ids);
    }

    const TemporaryFolder folder;
};

TEST_F(Page, ShowsWhatCoreShows) {
    if (!fs::exists(pageFile())) GTEST_SKIP() << "the page was left out of this build";
    if (programNamed("chromium").empty() || programNamed("node").empty() ||
        !fs::exists(CHIARO_NODE_MODULES "/puppeteer-core"))
        GTEST_SKIP() << "no chromium, or no puppeteer-core in " CHIARO_NODE_MODULES
                        ": ./dev test installs them";
    const project::Project project = skullInThreeLights();
    save(project);
    const Outcome outcome = exportPage();
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.json()["objects"], 4);
    EXPECT_EQ(outcome.json()["bytes"], fs::file_size(page()));
    EXPECT_LT(fs::file_size(page()), 6u << 20);

    const nlohmann::json lightDrag{{"from", {200, 200}}, {"to", {290, 230}}, {"shift", true}};
    const nlohmann::json turn{{"from", {200, 200}}, {"to", {120, 215}}};
    const nlohmann::json told =
        shoot(page(), folder.path(),
              {{{"name", "lit"}, {"hash", "ui=off&method=view-aligned"}, {"drags", {lightDrag}}},
               {{"name", "turned"}, {"hash", "ui=off&method=view-dependent"}, {"drags", {lightDrag, turn}}},
               {{"name", "followed"}, {"hash", "ui=off"}, {"then", "ui=off&camera=40,14,0.9"}},
               {{"name", "sepia"}, {"hash", "ui=off&method=view-dependent&gradient=Sepia"}}});
    ASSERT_TRUE(told.is_object());
    EXPECT_EQ(told["console"], nlohmann::json::array());
    EXPECT_EQ(told["requests"], nlohmann::json::array());

    // Both textures lie within half a step of the picture; JPEG takes two or three.
    constexpr double mostDifference = 6;
    for (const auto& [shot, method] :
         {std::pair("lit", "view-aligned"), std::pair("turned", "view-dependent")}) {
        SCOPED_TRACE(shot);
        const std::string hash = told["hashes"][shot];
        project::Project seen = project;
        const std::vector<float> light = numbersIn(hash, "light"), camera = numbersIn(hash, "camera");
        ASSERT_EQ(light.size(), 3u) << hash;
        ASSERT_EQ(camera.size(), 3u) << hash;
        EXPECT_GT(glm::distance(glm::vec3(light[0], light[1], light[2]), project.lights[0].vector), 0.3f);
        EXPECT_EQ(std::abs(camera[0] - project.camera.azimuth) > 10, std::string(shot) == "turned") << hash;
        seen.lights[0].vector = {light[0], light[1], light[2]};
        seen.camera.azimuth = camera[0];
        seen.camera.elevation = camera[1];
        seen.camera.distance = camera[2];
        EXPECT_LT(difference(shot, seen, method), mostDifference);
        EXPECT_GT(difference(shot, project, method), 2 * mostDifference) << "the light was turned";
    }

    // In one step to another view, the strokes go with the objects.
    scene::Path path;
    scene::Camera camera = project.camera;
    path.setKey(1, camera);
    camera.azimuth = 40;
    camera.elevation = 14;
    camera.distance = 0.9f;
    path.setKey(2, camera);
    for (auto& channel : path.target) channel.keys.clear();
    nlohmann::json keys = project::jsonFromPath(path);
    keys["path"] = 1;
    writeFileAtomically(folder / "path.json", keys.dump());
    EXPECT_LT(difference("followed", project, "view-aligned", folder / "path.json"), mostDifference);

    project::Project sepia = project;
    for (project::Sample& sample : sepia.samples) sample.recoloring = gradient::colorPresets()[1].path;
    ASSERT_STREQ(gradient::colorPresets()[1].name, "Sepia");
    EXPECT_LT(difference("sepia", sepia, "view-dependent"), mostDifference);
}

TEST_F(Page, IsOneFileThatReplacesOnlyWhatItMay) {
    if (!fs::exists(pageFile())) GTEST_SKIP() << "the page was left out of this build";
    project::Project project = skullInThreeLights();
    project.views.count = 4;
    project.views.size = 64;
    project.levels.size = 64;
    save(project);
    ASSERT_EQ(exportPage({"--threads", "1"}).status, 0);
    const std::string first = readFile(page(), 64 << 20);
    const Outcome refused = exportPage();
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.error.find("--overwrite"), std::string::npos) << refused.error;
    ASSERT_EQ(exportPage({"--overwrite"}).status, 0);
    EXPECT_EQ(readFile(page(), 64 << 20), first) << "the same scene gives the same bytes";
    EXPECT_EQ(filesIn(folder.path()).size(), 2u);
}

TEST_F(Page, LeftOutOfTheBuildIsOneSentence) {
    save(skullInThreeLights());
    // A program without what is installed beside it.
    fs::create_directories(folder / "bin");
    fs::copy_file(CHIARO_PROGRAM, folder / "bin/chiaro");
    const std::string command =
        fmt::format("{} export {} -o {} 2> {}", quoted(folder / "bin/chiaro"),
                    quoted(folder / "skull.chiaro"), quoted(page()), quoted(folder / "error"));
    EXPECT_EQ(std::system(command.c_str()) >> 8, 1);
    const std::string error = readFile(folder / "error", 4096);
    EXPECT_TRUE(error.starts_with("chiaro: relightable page: was left out when Chiaro was built")) << error;
    EXPECT_EQ(std::ranges::count(error, '\n'), 1) << error;
    EXPECT_FALSE(fs::exists(page()));
}

}  // namespace
}  // namespace chiaro::test
