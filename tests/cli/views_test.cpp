#include "core/base/atomic_file.h"
#include "core/base/image_io.h"
#include "core/scene/mesh_io.h"
#include "tests/cli/program.h"
#include "tests/support/support.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <set>

namespace chiaro::test {
namespace {

const std::string shell = resource("demo/meshes/shell.ply").string();

/// Two tents, each an object of two quads, the smaller under the larger; and a face without area.
const char* const tents =
    "v -2 0 -2\nv 2 0 -2\nv 2 0 2\nv -2 0 2\nv -2 3 0\nv 2 3 0\n"
    "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 1 0\nv 1 1 0\n"
    "o large\nf 4 3 6 5\nf 2 1 5 6\no small\nf 10 9 12 11\nf 8 7 11 12\nf 7 7 8\n";

glm::dmat4 matrixFrom(const nlohmann::json& numbers) {
    EXPECT_EQ(numbers.size(), 16u);
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = numbers[std::size_t(i)].get<double>();
    return matrix;
}

/// Every face with area is in a view that it faces, and lies inside that view's picture.
void expectFacesInTheirViews(const nlohmann::json& json, const scene::Mesh& mesh) {
    std::set<std::size_t> found(json["unreachable"].begin(), json["unreachable"].end());
    for (const nlohmann::json& view : json["views"]) {
        const glm::dmat4 toView = matrixFrom(view["view"]);
        const glm::dmat4 toClip = matrixFrom(view["projection"]) * toView;
        for (const std::size_t face : view["faces"]) {
            found.insert(face);
            std::array<glm::dvec3, 3> seen;
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec4 corner(glm::dvec3(mesh.positions[mesh.triangles.at(face)[k]]), 1);
                seen[k] = glm::dvec3(toView * corner);
                const glm::dvec4 clip = toClip * corner;
                EXPECT_LT(std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}), clip.w);
            }
            EXPECT_GT(glm::cross(seen[1] - seen[0], seen[2] - seen[0]).z, 0);  // counter-clockwise: the front
        }
    }
    EXPECT_EQ(found.size(), mesh.triangles.size());
}

TEST(Views, TellsWhatTheContractNames) {
    const TemporaryFolder folder;
    const std::filesystem::path mesh = folder / "tents.obj";
    writeFileAtomically(mesh, tents);
    const Outcome outcome =
        chiaro({"views", mesh, "-o", folder / "out", "--count", "5", "--size", "256", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const nlohmann::json json = outcome.json();
    EXPECT_EQ(json["faces"], 9);
    EXPECT_EQ(json["coverage"], 1);
    EXPECT_EQ(json["unreachable"], nlohmann::json({8}));
    EXPECT_GE(json["passes"], 1);
    EXPECT_EQ(std::ranges::count_if(json["views"], [](const auto& view) { return view["pass"] == 1; }), 5);
    EXPECT_EQ(json["views"][0]["width"], 256);
    EXPECT_EQ(json["views"][0]["height"], 256);
    expectFacesInTheirViews(json, scene::merged(scene::readModel(mesh).meshes));
    EXPECT_EQ(nlohmann::json::parse(readFile(folder / "out/views.json", 1 << 20)), json);
    std::size_t thumbnails = 0;
    for (const auto& file : filesIn(folder / "out")) thumbnails += file.extension() == ".png";
    EXPECT_EQ(thumbnails, json["views"].size());
}

TEST(Views, OfTheDemoShellCoverItWhateverTheThreads) {
    const TemporaryFolder folder;
    const Outcome one = chiaro({"views", shell, "-o", folder / "a", "--json", "--threads", "1"});
    const Outcome two = chiaro({"views", shell, "-o", folder / "b", "--json", "--threads", "2"});
    ASSERT_EQ(one.status, 0) << one.error;
    EXPECT_EQ(one.out, two.out);
    EXPECT_EQ(readFile(folder / "a/view_01.png", 1 << 24), readFile(folder / "b/view_01.png", 1 << 24));
    EXPECT_EQ(one.json()["coverage"], 1);
    expectFacesInTheirViews(one.json(), scene::merged(scene::readModel(shell).meshes));
    const DecodedImage thumbnail = readImage(folder / "a/view_01.png");
    EXPECT_EQ(thumbnail.width, 360);
    EXPECT_EQ(thumbnail.values[0], 1);  // white around the shell
    const std::size_t center = (180 * 360 + 180) * 3;
    EXPECT_GT(thumbnail.values[center], thumbnail.values[center + 2] + 0.3f);  // its faces tinted
}

TEST(Views, UpStandsUprightInThem) {
    const TemporaryFolder folder;
    const Outcome outcome =
        chiaro({"views", shell, "-o", folder / "out", "--json", "--count", "4", "--up", "0,0,2"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    for (const nlohmann::json& view : outcome.json()["views"]) {
        const glm::dvec4 up = matrixFrom(view["view"]) * glm::dvec4(0, 0, 1, 0);
        EXPECT_NEAR(up.x, 0, 1e-9);
        EXPECT_GE(up.y, 0);
    }
}

TEST(Views, RefusesWhatCannotBe) {
    const TemporaryFolder folder;
    const std::filesystem::path line = folder / "line.obj";
    writeFileAtomically(line, "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n");
    for (const auto& [status, arguments] : std::vector<std::pair<int, std::vector<std::string>>>{
             {2, {"views", shell}},
             {2, {"views", shell, "-o", folder / "out", "--count", "65"}},
             {2, {"views", shell, "-o", folder / "out", "--up", "0,0,0"}},
             {2, {"views", shell, "-o", folder / "out", "--up", "1,2"}},
             {1, {"views", folder / "missing.obj", "-o", folder / "out"}},
             {1, {"views", line, "-o", folder / "out"}}}) {
        const Outcome outcome = chiaro(arguments);
        EXPECT_EQ(outcome.status, status) << outcome.error;
        EXPECT_TRUE(outcome.error.starts_with("chiaro: ")) << outcome.error;
        EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }
}

}  // namespace
}  // namespace chiaro::test
