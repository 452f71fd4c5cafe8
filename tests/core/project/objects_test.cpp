#include "core/project/objects.h"

#include "core/base/atomic_file.h"
#include "core/project/pipeline.h"
#include "tests/support/support.h"

#include <spdlog/fmt/fmt.h>

#include <chrono>

namespace chiaro::project {
namespace {

std::vector<std::string> namesOf(const std::vector<ObjectSettings>& objects) {
    std::vector<std::string> names;
    for (const ObjectSettings& object : objects) names.push_back(object.name);
    return names;
}

Project twoFiles() {
    Project project;
    project.meshes = {{"/a.obj"}, {"/b.obj"}};
    return project;
}

using Names = std::vector<std::string>;

TEST(Objects, FollowTheFilesAndGetNamesOfTheirOwn) {
    const Project project = twoFiles();
    const auto all = allObjects(project, {{"head", "jaw"}, {"jaw", "table"}});
    EXPECT_EQ(namesOf(all), (Names{"head", "jaw", "jaw 2", "table"}));
    EXPECT_EQ(all[2].sourceName(), "jaw");
    EXPECT_EQ(all[2].mesh, 1);
    EXPECT_EQ(all[3].sample, 0);
}

TEST(Objects, ThatTheProjectNamesKeepTheirSettingsWhateverTheirOrder) {
    Project project = twoFiles();
    project.objects = {{.name = "table", .mesh = 1, .sample = 2},
                       {.name = "left jaw", .source = "jaw", .sample = 1},
                       {.name = "right jaw", .source = "jaw", .visible = false}};
    const auto all = allObjects(project, {{"head", "jaw"}, {"table"}});
    EXPECT_EQ(namesOf(all), (Names{"head", "left jaw", "right jaw", "table"}));
    EXPECT_EQ(all[1].sample, 1);
    EXPECT_FALSE(all[2].visible);
    EXPECT_EQ(all[3].sample, 2);
}

TEST(Objects, TakenOutOfTheSceneStayOut) {
    Project project = twoFiles();
    project.meshes[0].without = {"jaw"};
    EXPECT_EQ(namesOf(allObjects(project, {{"head", "jaw"}, {"jaw"}})), (Names{"head", "jaw"}));
}

TEST(Objects, OfAFileThatIsNotThereStay) {
    Project project = twoFiles();
    project.objects = {{.name = "head"}, {.name = "table", .mesh = 1}};
    EXPECT_EQ(namesOf(allObjects(project, {{}, {"table"}})), (Names{"head", "table"}));
    const scene::Scene scene = makeScene(project, {{}, {}});
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].mesh, nullptr);
}

TEST(Objects, StandWhereTheirPlacementPutsThem) {
    scene::Mesh mesh;
    mesh.name = "triangle";
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.triangles = {{0, 1, 2}};
    Project project;
    project.meshes = {{"/a.obj"}};
    project.objects = {{.name = "triangle"}, {.name = "copy", .source = "triangle"}};
    project.objects[1].placement = {.position = {5, 0, 0}, .scale = {2, 2, 2}};
    const auto shared = std::make_shared<const scene::Mesh>(mesh);
    const scene::Scene scene = makeScene(project, {{shared}});
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].transform, glm::mat4(1));
    EXPECT_EQ(scene.objects[1].mesh, shared);
    // The centre (1, 1, 0) moves by 5; the corner at the origin lies twice as far from it.
    EXPECT_EQ(glm::vec3(scene.objects[1].transform[3]), glm::vec3(4, -1, 0));
}

std::shared_ptr<const scene::Mesh> meshNamed(const std::string& name) {
    scene::Mesh mesh;
    mesh.name = name;
    return std::make_shared<const scene::Mesh>(std::move(mesh));
}

/// What takes seconds when every object is looked for among all others takes a fraction of one.
TEST(Objects, AsManyAsThereMayBeAreMadeQuickly) {
    constexpr int count = 65'535;
    Project project;
    project.meshes = {{"/a.glb"}, {"/b.glb"}};
    std::vector<MeshList> models(2);
    for (int i = 0; i < count; ++i) models[std::size_t(i % 2)].push_back(meshNamed(fmt::format("{}", i / 2)));
    for (int i = 0; i < count; i += 8) project.meshes[std::size_t(i % 2)].without.push_back("none");
    const auto start = std::chrono::steady_clock::now();
    const scene::Scene scene = makeScene(project, models);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    ASSERT_EQ(scene.objects.size(), std::size_t(count));
    EXPECT_EQ(scene.objects[40'000].name, "7232 2") << "the second file's names are taken";
    EXPECT_EQ(scene.objects[40'000].mesh, models[1][7232]);
    EXPECT_LT(time.count(), 1.5);
}

TEST(Objects, GetTheSmallestNumberThatIsFree) {
    std::vector<ObjectSettings> objects(3);
    objects[0].name = "cube";
    objects[1].name = "cube 3";
    objects[2].name = "ball";
    UniqueNames names(objects);
    EXPECT_EQ(names.take("cube"), "cube 2");
    EXPECT_EQ(names.take("cube"), "cube 4");
    EXPECT_EQ(names.take("cone"), "cone");
    EXPECT_EQ(names.take("cone"), "cone 2");
    EXPECT_EQ(uniqueName("ball", objects), "ball 2");
}

TEST(Missing, FilesAreFoundBesideTheOneThatTheArtistNames) {
    const test::TemporaryFolder folder;
    for (const char* file : {"new/scans/oil.png", "new/meshes/head.obj", "new/chalk.png", "kept.png"})
        writeFileAtomically(folder / file, "x");
    Project project;
    for (const char* scan : {"old/scans/oil.png", "old/scans/chalk.png", "kept.png", "old/gone.png"})
        project.samples.push_back(
            {.name = "a", .scan = folder / scan, .strip = {}, .gradient = {}, .recoloring = {}});
    project.meshes = {{folder / "old/meshes/head.obj"}};
    const auto missing = missingFiles(project);
    ASSERT_EQ(missing.size(), 4u);
    EXPECT_EQ(missing[3], (MissingFile{MissingFile::Kind::Mesh, 0, folder / "old/meshes/head.obj"}));
    relink(project, missing[0], folder / "new/scans/oil.png");
    EXPECT_EQ(project.samples[0].scan, folder / "new/scans/oil.png");
    EXPECT_EQ(project.meshes[0].path, folder / "new/meshes/head.obj") << "as far from it as before";
    EXPECT_EQ(project.samples[2].scan, folder / "kept.png") << "it never was missing";
    ASSERT_EQ(missingFiles(project).size(), 2u);
    relink(project, missing[1], folder / "new/chalk.png");
    ASSERT_EQ(missingFiles(project).size(), 1u);
    EXPECT_EQ(missingFiles(project)[0].path, folder / "old/gone.png");
}

TEST(Missing, FilesAreFoundAnywhereInAFolder) {
    const test::TemporaryFolder folder;
    for (const char* file :
         {"new/a/oil.png", "new/scans/2024/oil.png", "new/deep/er/head.obj", "new/x/head.obj/y"})
        writeFileAtomically(folder / file, "x");
    Project project;
    for (const char* scan : {"old/scans/2024/oil.png", "old/gone.png"})
        project.samples.push_back(
            {.name = "a", .scan = folder / scan, .strip = {}, .gradient = {}, .recoloring = {}});
    project.meshes = {{folder / "old/meshes/head.obj"}};
    relinkFrom(project, folder / "new");
    EXPECT_EQ(project.samples[0].scan, folder / "new/scans/2024/oil.png") << "the one that lies as it did";
    EXPECT_EQ(project.meshes[0].path, folder / "new/deep/er/head.obj") << "no folder is a mesh";
    ASSERT_EQ(missingFiles(project).size(), 1u);
    EXPECT_NO_THROW(relinkFrom(project, folder / "nowhere"));
}

}  // namespace
}  // namespace chiaro::project
