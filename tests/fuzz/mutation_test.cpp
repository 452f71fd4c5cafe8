#include "core/base/error.h"
#include "core/base/image_import.h"
#include "core/project/animation.h"
#include "core/project/presets.h"
#include "core/scene/mesh_import.h"
#include "tests/cli/program.h"
#include "tests/core/base/raw_files.h"
#include "tests/fuzz/corpus.h"
#include "tests/fuzz/mutator.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace chiaro {
namespace {

using namespace test;

bool isFinite(const glm::vec3& vector) {
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

/// Whether a picture is one: sizes agree, values are numbers.
bool isSound(const DecodedImage& image) {
    const std::size_t count =
        std::size_t(image.width) * std::size_t(image.height) * std::size_t(image.channels);
    return image.width > 0 && image.height > 0 && image.channels >= 1 && image.channels <= 4 &&
           image.values.size() == count &&
           std::ranges::all_of(image.values, [](float value) { return std::isfinite(value); });
}

bool isSound(const scene::Model& model) {
    std::size_t faces = 0;
    for (const scene::Mesh& mesh : model.meshes) {
        faces += mesh.triangles.size();
        if (mesh.name.empty() || mesh.normals.size() != mesh.positions.size()) return false;
        if (!std::ranges::all_of(mesh.positions, isFinite) || !std::ranges::all_of(mesh.normals, isFinite))
            return false;
        for (const scene::Triangle& triangle : mesh.triangles)
            for (const std::uint32_t vertex : triangle)
                if (vertex >= mesh.positions.size()) return false;
    }
    return faces == model.faces && faces > 0;
}

/// Whether a project can be worked with: what it refers to is there, what it sets is in range.
bool isSound(const project::Project& project) {
    for (const project::ObjectSettings& object : project.objects)
        if (object.mesh < 0 || object.sample < 0 || !isFinite(object.placement.position)) return false;
    for (const scene::Light& light : project.lights)
        if (!isFinite(light.vector) || !std::isfinite(light.intensity)) return false;
    const project::Animation& animation = project.animation;
    return animation.firstFrame >= 1 && animation.lastFrame >= animation.firstFrame &&
           animation.lastFrame <= animation.frames && std::isfinite(project.camera.distance);
}

bool isSound(const scene::Path& path) {
    return std::ranges::all_of(path.azimuth.keys, [](const auto& key) { return std::isfinite(key.value); });
}

bool isSound(const project::Preset& preset) {
    if (const auto* path = std::get_if<gradient::ColorPath>(&preset))
        return !path->stops.empty() && isFinite(path->at(0.5f));
    if (const auto* plan = std::get_if<project::ViewPlanPreset>(&preset))
        return std::ranges::all_of(plan->placed, isFinite, &project::PlacedView::direction);
    return !std::get<project::MethodPreset>(preset).method.empty();
}

/// How the mutations of a format ended.
struct Tally {
    std::size_t accepted = 0;
    std::size_t refused = 0;
    std::size_t crashed = 0;  ///< in the helper, and told as a sentence
    std::size_t hung = 0;
};

class Mutation : public testing::TestWithParam<Format> {
protected:
    bool openIsSound(const std::filesystem::path& path) {
        switch (GetParam().as) {
            case Opened::Picture:
                return isSound(importImage(m_helpers, path, {}, {}));
            case Opened::Mesh:
                return isSound(scene::importModel(m_helpers, path, {}));
            case Opened::Project:
                return isSound(project::readProject(path));
            case Opened::Path:
                return isSound(project::readPath(path));
            case Opened::Preset:
                return isSound(project::readPreset(path));
        }
        return false;
    }

    void open(const std::filesystem::path& path, std::size_t number, Tally& tally) {
        try {
            EXPECT_TRUE(openIsSound(path)) << "mutation " << number;
            ++tally.accepted;
        } catch (const Error& error) {
            const std::string sentence = error.what();
            EXPECT_TRUE(sentence.starts_with(path.string())) << number << ": " << sentence;
            EXPECT_NE(sentence.find("; "), sentence.npos) << number << ": " << sentence;
            EXPECT_EQ(sentence.find('\n'), sentence.npos) << number << ": " << sentence;
            tally.crashed += sentence.find("its reader crashed") != sentence.npos;
            EXPECT_EQ(sentence.find("without sense"), sentence.npos) << number << ": " << sentence;
            tally.hung += sentence.find("was not read within") != sentence.npos;
            ++tally.refused;
        } catch (const std::exception& other) {
            ADD_FAILURE() << "mutation " << number << " throws " << other.what();
        }
    }

    TemporaryFolder m_folder;
    helper::HelperPool m_helpers{{.seconds = 60}};
};

/// What the studio and the command line open files with takes whatever they hold.
TEST_P(Mutation, IsReadOrRefusedWithASentence) {
    const Format& format = GetParam();
    const Mutator mutator(format.corpus());
    const auto path = m_folder / ("mutated" + format.extension);
    Tally tally;
    const std::size_t count = rounds(200, 10'000);
    for (std::size_t number = 0; number < count; ++number) {
        std::filesystem::remove(path);
        save(path, mutator.mutation(number));
        open(path, number, tally);
    }
    std::printf(
        "%s: %zu mutations, %zu read, %zu refused, of these %zu after a crash of the helper, %zu hung\n",
        format.name.c_str(), count, tally.accepted, tally.refused, tally.crashed, tally.hung);
    EXPECT_EQ(tally.hung, 0u);
    const bool isOurs = format.as == Opened::Mesh;
    EXPECT_TRUE(tally.crashed == 0 || !isOurs);
    EXPECT_GT(tally.refused, 0u);
}

std::vector<std::string> commandFor(Opened as, const std::filesystem::path& path,
                                    const std::filesystem::path& out) {
    const std::string oil = resource("demo/samples/oil.png").string();
    const std::string shell = resource("demo/meshes/shell.ply").string();
    switch (as) {
        case Opened::Picture:
            return {"sample", "info", path.string()};
        case Opened::Mesh:
            return {"views", path.string(), "--count", "1", "-o", out.string()};
        case Opened::Project:
            return {"render", path.string(), "--size", "16x16", "-o", (out / "a.png").string()};
        case Opened::Preset:
            break;
        case Opened::Path:
            return {"animate", "--mesh",      shell,         "--sample", oil,
                    "--path",  path.string(), "--size",      "16x16",    "--frames",
                    "1-1",     "--method",    "image-based", "-o",       (out / "a.####.png").string()};
    }
    return {};  // presets are the studio's
}

/// The whole program: done, or one line on stderr and status 1; never a signal.
TEST_P(Mutation, NeverCrashesTheCommandLine) {
    const Format& format = GetParam();
    if (format.as == Opened::Preset) GTEST_SKIP() << "presets are the studio's";
    const Mutator mutator(format.corpus());
    const auto path = m_folder / ("mutated" + format.extension);
    for (std::size_t number = 0; number < rounds(2, 100); ++number) {
        save(path, mutator.mutation(1'000'000 + number));
        const Outcome outcome = test::chiaro(commandFor(format.as, path, m_folder / "out"));
        EXPECT_TRUE(outcome.status == 0 || outcome.status == 1) << number << ": " << outcome.status;
        EXPECT_LE(std::ranges::count(outcome.error, '\n'), 1) << number << ": " << outcome.error;
    }
}

INSTANTIATE_TEST_SUITE_P(, Mutation, testing::ValuesIn(formats()),
                         [](const auto& one) { return one.param.name; });

/// The files that mutations start from are sound themselves.
TEST_P(Mutation, BeginsWithSoundFiles) {
    const auto path = m_folder / ("sound" + GetParam().extension);
    for (const std::string& bytes : GetParam().corpus()) {
        save(path, bytes);
        EXPECT_TRUE(openIsSound(path));
    }
}

TEST(Mutator, GivesTheSameBytesForTheSameNumber) {
    const Mutator one(formats().front().corpus()), other(formats().front().corpus());
    std::size_t different = 0;
    for (std::size_t number = 0; number < 100; ++number) {
        EXPECT_EQ(one.mutation(number), other.mutation(number));
        different += one.mutation(number) != one.mutation(number + 1);
    }
    EXPECT_GE(different, 95u);
}

}  // namespace
}  // namespace chiaro
