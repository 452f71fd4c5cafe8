#include "core/project/project.h"

#include "core/base/atomic_file.h"
#include "core/base/image_io.h"
#include "core/scene/mesh_io.h"
#include "tests/cli/program.h"
#include "tests/support/support.h"

namespace chiaro::test {
namespace {

/// The shell and, beside it, the skull a fifth as large, in two paints.
project::Project shellAndSkull() {
    project::Project project;
    for (const char* sample : {"oil", "charcoal"})
        project.samples.push_back({.name = sample,
                                   .scan = resource(std::string("demo/samples/") + sample + ".png"),
                                   .strip = {},
                                   .gradient = {},
                                   .recoloring = {}});
    project.meshes = {{resource("demo/meshes/shell.ply")}, {resource("demo/meshes/skull.glb")}};
    for (const char* part : {"cranium", "jaw"})
        project.objects.push_back(
            {.name = part, .mesh = 1, .sample = 1, .placement = {.position = {3, 0, 0}}});
    project.meshes[1].without = {"upper teeth", "lower teeth"};
    project.levels.size = 64;
    project.levels.count = 4;
    return project;
}

int painted(const TemporaryFolder& folder, const project::Project& project,
            std::vector<std::string> more = {}) {
    project::writeProject(folder / "a.chiaro", project);
    std::vector<std::string> arguments{"render", folder / "a.chiaro", "--size", "96x96",
                                       "-o",     folder / "a.png",    "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = chiaro(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    return outcome.status == 0 ? outcome.json()["pixels"].get<int>() : 0;
}

TEST(ProjectFile, SeveralMeshFilesArePaintedTogether) {
    const TemporaryFolder folder;
    project::Project project = shellAndSkull();
    const int both = painted(folder, project);
    project.objects[0].visible = project.objects[1].visible = false;
    project.frameCamera = true;
    const int shellAlone = painted(folder, project);
    EXPECT_GT(both, 500);
    EXPECT_GT(shellAlone, both) << "it fills the picture by itself";
    EXPECT_EQ(painted(folder, project, {"--mesh", resource("demo/meshes/shell.ply").string()}), shellAlone);
}

TEST(ProjectFile, AnObjectThatItsFileLacksIsNamed) {
    const TemporaryFolder folder;
    project::Project project = shellAndSkull();
    project.objects[1].source = "tail";
    project::writeProject(folder / "a.chiaro", project);
    const Outcome outcome = chiaro({"render", folder / "a.chiaro", "-o", folder / "a.png"});
    EXPECT_NE(outcome.status, 0);
    EXPECT_NE(outcome.error.find("skull.glb: has no object \"tail\""), std::string::npos) << outcome.error;
}

TEST(ProjectFile, ShadowsAreFlagsAndPartOfTheProject) {
    const TemporaryFolder folder;
    project::Project project = shellAndSkull();
    project.lights[0].wrap = false;
    const auto bytesOf = [&](const std::vector<std::string>& flags) {
        painted(folder, project, flags);
        return readImage(folder / "a.png", {}).values;
    };
    const auto open = bytesOf({}), shaded = bytesOf({"--shadows", "on", "--ambient-occlusion", "0.5"});
    project.occlusion = {.shadows = true, .ambient = 0.5};
    EXPECT_NE(open, shaded);
    EXPECT_EQ(bytesOf({}), shaded);
}

TEST(ProjectFile, AnimationsGoByItsKeysAndItsRenderRange) {
    const TemporaryFolder folder;
    project::Project project = shellAndSkull();
    project.animation.frames = 20;
    project.animation.firstFrame = 4;
    project.animation.lastFrame = 6;
    project.animation.path.smooth = false;
    project.animation.path.azimuth.keys = {{1, 30}, {11, 130}};
    project::writeProject(folder / "a.chiaro", project);
    writeFileAtomically(folder / "path.json", R"({"path": 1, "interpolation": "linear", "keys": [
        {"frame": 1, "azimuth": 30}, {"frame": 11, "azimuth": 130}]})");
    const auto animate = [&](const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> arguments{
            "animate", folder / "a.chiaro", "--size", "48x48", "--json", "-o", folder / (name + ".####.png")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = chiaro(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return outcome.status == 0 ? outcome.json()["frames"].get<int>() : 0;
    };
    EXPECT_EQ(animate("own", {}), 3);
    EXPECT_EQ(animate("file", {"--path", folder / "path.json", "--frames", "4-6"}), 3);
    EXPECT_EQ(animate("turn", {"--path", "turntable", "--frames", "4-4"}), 1);
    const auto pixels = [&](const char* name) { return readImage(folder / name, {}).values; };
    for (const char* frame : {".0004.png", ".0005.png", ".0006.png"})
        EXPECT_EQ(pixels((std::string("own") + frame).c_str()),
                  pixels((std::string("file") + frame).c_str()));
    EXPECT_NE(pixels("own.0004.png"), pixels("turn.0004.png"));
    const Outcome period = chiaro(
        {"animate", folder / "a.chiaro", "--size", "48x48", "--period", "12", "-o", folder / "p.####.png"});
    EXPECT_EQ(period.status, 2);
    EXPECT_NE(period.error.find("--path turntable"), std::string::npos) << period.error;
}

TEST(ProjectFile, AFlagDressesObjectsOfAnyMeshFile) {
    const TemporaryFolder folder;
    const std::string hatching = resource("demo/samples/hatching.png").string();
    project::Project project = shellAndSkull();
    const auto picture = [&](const project::Project& shown, const std::vector<std::string>& flags) {
        painted(folder, shown, flags);
        return readImage(folder / "a.png", {}).values;
    };
    // As a project that was written by hand: its objects have the names that their files give them.
    project.objects.clear();
    project.frameCamera = true;
    const std::string second = scene::readModel(project.meshes[1].path).meshes.front().name;
    project::Project dressed = project;
    dressed.samples.push_back(dressed.samples[0]);
    dressed.samples[1].scan = hatching;
    dressed.objects = {{.name = second, .mesh = 1, .sample = 1}};
    EXPECT_EQ(picture(project, {"--object", second + "=" + hatching}), picture(dressed, {}));
    project::writeProject(folder / "a.chiaro", project);
    const Outcome unknown =
        chiaro({"render", folder / "a.chiaro", "--object", "tail=" + hatching, "-o", folder / "b.png"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.error.find("has no object \"tail\""), std::string::npos) << unknown.error;
    EXPECT_NE(unknown.error.find("\"" + second + "\""), std::string::npos) << unknown.error;
}

}  // namespace
}  // namespace chiaro::test
