#include "core/project/collect.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/project/backups.h"
#include "tests/support/support.h"

#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <unistd.h>

namespace chiaro::project {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
    return readFile(path, 1 << 20);
}

std::vector<std::string> treeOf(const fs::path& folder) {
    std::vector<std::string> files;
    std::error_code ignored;
    for (const auto& entry : fs::recursive_directory_iterator(folder, ignored))
        if (entry.is_regular_file())
            files.push_back(entry.path().lexically_relative(folder).generic_string());
    std::ranges::sort(files);
    return files;
}

using Files = std::vector<std::string>;

/// Two scans and two meshes of the same name in different folders, one mesh with side files, one scan
/// missing.
Project scattered(const test::TemporaryFolder& folder) {
    for (const auto& [file, text] : std::vector<std::pair<std::string, std::string>>{
             {"one/oil.png", "scan one"},
             {"two/Oil.png", "scan two"},
             {"one/head.ply", "mesh one"},
             {"two/head.ply", "mesh two"},
             {"three/cup.obj", "mtllib cup.mtl\nv 0 0 0\n"},
             {"three/cup.mtl", "newmtl a\nmap_Kd tex/glaze.png\n"},
             {"three/tex/glaze.png", "texture"}})
        writeFileAtomically(folder / file, text);
    Project project;
    for (const char* scan : {"one/oil.png", "two/Oil.png", "one/oil.png", "gone/chalk.png"})
        project.samples.push_back(
            {.name = "a", .scan = folder / scan, .strip = {}, .gradient = {}, .recoloring = {}});
    for (const char* mesh : {"one/head.ply", "two/head.ply", "three/cup.obj"})
        project.meshes.push_back({folder / mesh});
    return project;
}

TEST(Collect, BringsEverythingIntoOneFolderThatMayBeMoved) {
    const test::TemporaryFolder folder;
    const Project project = scattered(folder);
    const Collection collection = planCollection(project, folder / "all/study.chiaro");
    EXPECT_FALSE(fs::exists(folder / "all")) << "a plan writes nothing";
    EXPECT_EQ(collection.left, std::vector<fs::path>{folder / "gone/chalk.png"});
    collectFiles(collection);
    const Files expected{"meshes/cup/cup.mtl", "meshes/cup/cup.obj", "meshes/cup/tex/glaze.png",
                         "meshes/head 2.ply",  "meshes/head.ply",    "scans/Oil 2.png",
                         "scans/oil.png",      "study.chiaro"};
    EXPECT_EQ(treeOf(folder / "all"), expected);
    EXPECT_EQ(collection.targets().size(), expected.size());
    for (const char* source : {"one", "two", "three"}) fs::remove_all(folder / source);
    fs::create_directories(folder / "elsewhere");
    fs::rename(folder / "all", folder / "elsewhere/moved");
    const Project read = readProject(folder / "elsewhere/moved/study.chiaro");
    EXPECT_EQ(textOf(read.samples[0].scan), "scan one");
    EXPECT_EQ(textOf(read.samples[1].scan), "scan two");
    EXPECT_EQ(read.samples[2].scan, read.samples[0].scan) << "copied once";
    EXPECT_EQ(textOf(read.meshes[1].path), "mesh two");
    EXPECT_EQ(textOf(read.meshes[2].path.parent_path() / "tex/glaze.png"), "texture");
}

TEST(Collect, LeavesWhatIsInTheFolderWhereItIs) {
    const test::TemporaryFolder folder;
    Project project = scattered(folder);
    writeFileAtomically(folder / "all/scans/Oil.png", "kept");
    project.samples[3].scan = folder / "all/scans/Oil.png";
    const Collection collection = planCollection(project, folder / "all/study.chiaro");
    collectFiles(collection);
    const Project read = readProject(folder / "all/study.chiaro");
    EXPECT_EQ(textOf(folder / "all/scans/Oil.png"), "kept");
    EXPECT_EQ(read.samples[3].scan, folder / "all/scans/Oil.png");
    EXPECT_EQ(textOf(read.samples[0].scan), "scan one");
    // Once more changes nothing: all is there.
    const Collection again = planCollection(read, folder / "all/study.chiaro");
    EXPECT_TRUE(again.files.empty());
    EXPECT_EQ(again.project, read);
}

TEST(Collect, LeavesNothingHalfWritten) {
    const test::TemporaryFolder folder;
    const Project project = scattered(folder);
    const Collection collection = planCollection(project, folder / "all/study.chiaro");
    fs::remove(folder / "three/cup.mtl");
    EXPECT_THROW(collectFiles(collection), Error);
    EXPECT_FALSE(fs::exists(folder / "all"));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(collectFiles(planCollection(project, folder / "all/study.chiaro"), Task(stop.get_token())),
                 Cancelled);
    EXPECT_FALSE(fs::exists(folder / "all"));
    writeFileAtomically(folder / "file", "x");
    EXPECT_THROW(collectFiles(planCollection(project, folder / "file/all/study.chiaro")), Error);
}

/// As on a full disk: no file may grow beyond what the last of them needs.
TEST(Collect, AFullDiskChangesNothing) {
    const test::TemporaryFolder folder;
    const Project project = scattered(folder);
    writeFileAtomically(folder / "two/head.ply", std::string(300'000, 'x'));
    writeFileAtomically(folder / "all/study.chiaro", "mine");
    const Collection collection = planCollection(project, folder / "all/study.chiaro");
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{200'000, 200'000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            collectFiles(collection);
        } catch (const Error& error) {
            ::_exit(std::string(error.what()).find("head 2.ply") != std::string::npos ? 3 : 4);
        }
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 3);
    EXPECT_EQ(treeOf(folder / "all"), Files{"study.chiaro"});
    EXPECT_FALSE(fs::exists(folder / "all/meshes"));
    EXPECT_EQ(textOf(folder / "all/study.chiaro"), "mine");
}

TEST(Collect, NeverReplacesAProjectOfANewerFormat) {
    const test::TemporaryFolder folder;
    const Project project = scattered(folder);
    writeFileAtomically(folder / "all/study.chiaro", R"({"chiaro": 99})");
    EXPECT_THROW(collectFiles(planCollection(project, folder / "all/study.chiaro")), Error);
    EXPECT_EQ(treeOf(folder / "all"), Files{"study.chiaro"});
}

}  // namespace
}  // namespace chiaro::project
