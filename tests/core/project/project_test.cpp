#include "core/project/project.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "tests/support/support.h"

namespace chiaro::project {
namespace {

Project everythingChanged(const test::TemporaryFolder& folder) {
    Project project;
    Sample& sample = project.samples.emplace_back();
    sample.name = "Öl \"dry\"";
    sample.scan = folder / "scans/öl 1.png";
    sample.strip.crop[2] = {0.9f, 0.8f};
    sample.strip.quarterTurns = 3;
    sample.strip.mirror = true;
    sample.strip.scale = 1.5;
    sample.gradient.searchScale = 2.5;
    sample.gradient.matchSpeed = false;
    sample.gradient.curve.points = {{0, 0}, {0.3f, 0.6f}, {1, 1}};
    sample.recoloring = gradient::ColorPath{{{0, {0.1f, 0.2f, 0.3f}}, {1, {1, 0.9f, 0.8f}}},
                                            gradient::ColorPath::Space::Oklab};
    project.samples.emplace_back().name = "second";
    project.samples.back().scan = folder / "second.tif";
    project.meshes = {{folder / "head.glb", {"ear", "hair"}}, {folder / "table.obj"}};
    project.objects.push_back({.name = "teeth", .sample = 1, .visible = false, .transform = glm::mat4(2)});
    project.objects.push_back({.name = "board",
                               .source = "plane",
                               .mesh = 1,
                               .placement = {{1, 2, 3}, {0, 90, 370.5f}, {1, -0.5f, 2}},
                               .views = {{.direction = {1, 2, 3}}}});
    project.lights = {
        {.vector = {0.1f, 0.2f, -0.3f}, .intensity = 0.7f, .wrap = false, .visible = false, .name = "Sun"},
        {.kind = scene::Light::Kind::Point, .vector = {0, 0, 0}}};
    project.occlusion = {.shadows = true, .ambient = 0.5, .ambientRadius = 40};
    project.animation = {.frames = 100, .firstFrame = 10, .lastFrame = 20, .rate = 12.5};
    project.animation.path.cameraTurn = 3.6;
    project.animation.path.approach = 0.98;
    project.animation.path.smooth = false;
    project.animation.path.setKey(1, scene::Camera{});
    project.animation.path.setKey(50, glm::vec3(0.1f, 0.2f, 0.3f));
    project.animation.path.setKey(60, glm::vec3(0));  // a light at a point may stand there
    project.animation.path.azimuth.set(20, 45);
    project.frameCamera = false;
    project.camera = {.azimuth = 12.5f, .elevation = -3, .distance = 1.25f, .target = {1, 2, 3}, .radius = 4};
    project.levels.count = 6;
    project.levels.tiling = synthesis::Tiling::Mask;
    project.levels.quilt.block = 24;
    project.viewAligned.density = 0.75;
    project.method = "image-based";
    project.imageBased.window = 7;
    project.imageBased.quilt = {.block = 20, .overlap = 6, .tolerance = 0.25, .seed = 9};
    return project;
}

TEST(Project, ReadsBackWhatItWrote) {
    const test::TemporaryFolder folder;
    const Project project = everythingChanged(folder);
    writeProject(folder / "a.chiaro", project);
    EXPECT_TRUE(readProject(folder / "a.chiaro") == project);
}

TEST(Project, PathsAreRelativeToTheFile) {
    const test::TemporaryFolder folder;
    writeProject(folder / "a.chiaro", everythingChanged(folder));
    const std::string text = readFile(folder / "a.chiaro", 1 << 20);
    EXPECT_NE(text.find("\"scans/öl 1.png\""), std::string::npos) << text;
    EXPECT_EQ(text.find(folder.path().string()), std::string::npos) << text;
    EXPECT_EQ(text.find("0.1000000"), std::string::npos) << text;
}

TEST(Project, WritingTwiceGivesTheSameBytes) {
    const test::TemporaryFolder folder;
    writeProject(folder / "a.chiaro", everythingChanged(folder));
    writeProject(folder / "b.chiaro", readProject(folder / "a.chiaro"));
    EXPECT_EQ(readFile(folder / "a.chiaro", 1 << 20), readFile(folder / "b.chiaro", 1 << 20));
}

TEST(Project, OfTheFirstFormatStillOpens) {
    const test::TemporaryFolder folder;
    writeFileAtomically(folder / "old.chiaro", R"({"chiaro": 1, "samples": [{"name": "a", "scan": "a.png"}],
        "mesh": "m/head.obj", "objects": [{"name": "jaw", "sample": 0, "visible": false}],
        "lights": [{"kind": "directional", "vector": [0, 1, 0]}]})");
    const Project project = readProject(folder / "old.chiaro");
    EXPECT_EQ(project.meshes, std::vector<MeshFile>{{folder / "m/head.obj"}});
    ASSERT_EQ(project.objects.size(), 1u);
    EXPECT_EQ(project.objects[0], (ObjectSettings{.name = "jaw", .visible = false}));
    EXPECT_EQ(project.lights[0].vector, glm::vec3(0, 1, 0));
}

std::string refusal(const std::string& text) {
    const test::TemporaryFolder folder;
    writeFileAtomically(folder / "bad.chiaro", text);
    try {
        readProject(folder / "bad.chiaro");
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Project, SaysWhatIsWrongWithAFile) {
    EXPECT_NE(refusal("").find("is not JSON"), std::string::npos);
    EXPECT_NE(refusal("{\"chiaro\": 1").find("is not JSON"), std::string::npos);
    EXPECT_NE(refusal("[]").find("is not an object"), std::string::npos);
    EXPECT_NE(refusal("{}").find("has no \"chiaro\""), std::string::npos);
    EXPECT_NE(refusal(R"({"chiaro": 99, "samples": []})").find("newer Chiaro (format 99)"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"chiaro": 1, "samples": 3})").find("a list"), std::string::npos);
    EXPECT_NE(refusal(R"({"chiaro": 1, "samples": [{"name": "a"}]})").find("samples 1: has no \"scan\""),
              std::string::npos);
    EXPECT_NE(refusal(R"({"chiaro": 1, "samples": [], "camera": {"elevation": 95}})").find("from -90 to 90"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"chiaro": 1, "samples": [], "levels": {"count": 1}})").find("2..32"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"chiaro": 1, "samples": [], "method": "guess"})").find("\"image-based\""),
              std::string::npos);
    EXPECT_NE(refusal(R"({"chiaro": 1, "samples": [], "image-based": {"window": 65}})").find("0..64"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"chiaro": 1, "samples": [], "lights": [{"vector": [0, 0, 0]}]})").find("not zero"),
              std::string::npos);
    EXPECT_NE(
        refusal(R"({"chiaro": 1, "samples": [], "objects": [{"name": "a", "sample": 0}]})").find("sample"),
        std::string::npos);
    const auto objects = [](const std::string& object) {
        return refusal(R"({"chiaro": 2, "samples": [{"name": "a", "scan": "a"}], "meshes": [{"file": "m"}],
            "objects": [{"name": "a", )" +
                       object + "}]}");
    };
    EXPECT_NE(objects(R"("mesh": 1)").find("from 0 to 0"), std::string::npos);
    EXPECT_NE(objects(R"("scale": [1, 0, 1])").find("not zero"), std::string::npos);
    EXPECT_EQ(objects(R"("scale": [1, -1, 1])"), "accepted");
    EXPECT_NE(refusal(R"({"chiaro": 2, "samples": [], "lights": [{"kind": "area"}]})").find("\"point\""),
              std::string::npos);
    EXPECT_NE(
        refusal(R"({"chiaro": 2, "samples": [], "animation": {"frames": 9, "range": [1, 10]}})").find("to 9"),
        std::string::npos);
    EXPECT_NE(refusal(R"({"chiaro": 2, "samples": [], "animation": {"keys": [{"frame": 0}]}})").find("frame"),
              std::string::npos);
    EXPECT_EQ(refusal(R"({"chiaro": 1, "samples": []})"), "accepted");
}

TEST(Project, OfANewerFormatIsReadAsFarAsItIsKnownAndNeverReplaced) {
    const test::TemporaryFolder folder;
    const auto file = folder / "a.chiaro";
    writeFileAtomically(file, R"({"chiaro": 3, "samples": [], "method": "image-based", "brushes": [1, 2]})");
    const ProjectFile read = readProjectFile(file);
    EXPECT_TRUE(read.isNewer());
    EXPECT_EQ(read.version, 3);
    EXPECT_EQ(read.project.method, "image-based");
    EXPECT_THROW(readProject(file), Error);
    EXPECT_THROW(refuseToReplaceNewer(file), Error);
    writeFileAtomically(file, R"({"chiaro": 3, "samples": {"by-name": {}}})");
    try {
        readProjectFile(file);
        FAIL() << "it can't be read";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("newer Chiaro (format 3)"), std::string::npos)
            << error.what();
    }
    writeFileAtomically(file, "no project");
    EXPECT_NO_THROW(refuseToReplaceNewer(file));
    EXPECT_NO_THROW(refuseToReplaceNewer(folder / "none.chiaro"));
    writeProject(file, Project());
    EXPECT_NO_THROW(refuseToReplaceNewer(file));
    EXPECT_FALSE(readProjectFile(file).isNewer());
}

TEST(Project, AFailedSaveLeavesTheOldFile) {
    const test::TemporaryFolder folder;
    writeFileAtomically(folder / "file", "old");
    EXPECT_THROW(writeProject(folder / "file" / "a.chiaro", Project()), Error);
    EXPECT_EQ(readFile(folder / "file", 10), "old");
}

}  // namespace
}  // namespace chiaro::project
