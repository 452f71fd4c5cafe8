// Memory that is refused once, at the k-th allocation of each step from file to file: the step fails with an
// error or doesn't mind; nothing ends the program, nothing is lost, and the next time it works as ever. Once
// our own allocations alone, without a reserve, so that every way out of our code is taken; once anybody's,
// libraries included, with the reserve that our programs keep. Long: with CHIARO_LONG_TESTS=1 in the
// environment every k up to 2,000, and a thousand later ones; otherwise some.

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/image_io.h"
#include "core/base/memory_reserve.h"
#include "core/base/random.h"
#include "core/export/textured_mesh.h"
#include "core/project/pipeline.h"
#include "core/sample/strip.h"
#include "core/scene/mesh_io.h"
#include "tests/core/scene/shapes.h"
#include "tests/faults/failing_allocator.h"
#include "tests/support/support.h"

#include <tbb/global_control.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <set>

namespace chiaro {
namespace {

using test::Refused;
using test::RefusedAllocation;

ColorImage paintedStrip() {
    ColorImage strip(96, 40);
    Random random(1, 0);
    for (int y = 0; y < strip.height(); ++y)
        for (int x = 0; x < strip.width(); ++x)
            strip(x, y) = glm::vec3(0.8f * float(x) / 95.0f + 0.2f * float(random.uniform()));
    return strip;
}

exporting::TexturedScene texturedBall() {
    const scene::Mesh mesh = test::ball(12, 8);
    exporting::TexturedObject object{"ball", glm::mat4(1), mesh.positions, mesh.normals,
                                     {},     {},           mesh.triangles};
    for (const glm::vec3& position : mesh.positions)
        object.coordinates.push_back(0.5f + 0.4f * glm::vec2(position));
    exporting::TexturedScene scene;
    scene.objects.push_back(std::move(object));
    scene.texture = exporting::ByteImage(32, 32, glm::u8vec3(200, 100, 50));
    return scene;
}

/// What the steps begin with, made before memory is short.
struct Stage {
    test::TemporaryFolder folder;
    ColorImage strip = paintedStrip();
    exporting::TexturedScene textured = texturedBall();
    project::Project project;
    scene::Scene scene;
    project::Paint paint;
    scene::GBuffer gbuffer;
    std::shared_ptr<const methods::PlannedObject> planned;

    Stage() {
        writeImage(folder / "strip.png", strip);
        writeImage(folder / "strip.exr", strip);
        for (const char* name : {"ball.obj", "ball.glb"})
            exporting::writeTexturedScene(folder / name, textured);
        project.samples.resize(1);
        project.samples[0].scan = folder / "strip.png";
        project.meshes = {{folder / "ball.obj"}};
        project.levels.count = 2;
        project.levels.size = 64;
        project.levels.quilt.block = 16;
        project.levels.quilt.overlap = 4;
        project.imageBased.quilt = project.levels.quilt;
        project.views.count = 3;
        project.views.size = 64;
        scene = project::makeScene(project, {{std::make_shared<const scene::Mesh>(test::ball(12, 8))}});
        paint = project::preparePaint(project, 0);
        gbuffer = castGBuffer();
        planned = project::planObject(project, scene, 0);
    }

    scene::GBuffer castGBuffer() const {
        const scene::RayScene rays(scene);
        return scene::castGBuffer(rays, scene.lights, project::cameraFor(project, scene), 48, 48);
    }
};

/// A step on its way from files to files; what it returns is the same each time.
struct Step {
    const char* name;
    std::uint64_t (*run)(const Stage& stage);
};

template <class Pixel>
void add(Hasher& hasher, const Image<Pixel>& image) {
    hasher.add(std::span<const Pixel>(image.pixels()));
}

std::uint64_t load(const Stage& stage) {
    Hasher hasher;
    for (const char* name : {"ball.obj", "ball.glb"})
        for (const scene::Mesh& mesh : scene::readModel(stage.folder / name).meshes)
            hasher.add(std::span(mesh.positions)).add(std::span(mesh.triangles));
    for (const char* name : {"strip.png", "strip.exr"}) add(hasher, sample::readScan(stage.folder / name));
    return hasher.value();
}

std::uint64_t separate(const Stage& stage) {
    sample::StripParams params;
    params.crop[0] = {0.05f, 0.1f};  // no rectangle, so that it is warped
    params.scale = 1.2;
    const auto separation = gradient::separate(sample::makeStrip(stage.strip, params));
    Hasher hasher;
    add(hasher, separation.texture);
    return hasher.add(std::span(separation.gradient)).value();
}

std::uint64_t synthesise(const Stage& stage) {
    const auto levels =
        synthesis::makeLevels(stage.strip, stage.paint.separation.gradient, stage.project.levels);
    Hasher hasher;
    for (const ColorImage& level : levels.levels) add(hasher, level);
    const auto painted = project::paintObject(stage.project, stage.planned, stage.paint);
    for (const methods::ViewTexture& view : painted->textures.views)
        for (const auto& level : view.levels) add(hasher, level);
    return hasher.value();
}

std::uint64_t render(const Stage& stage) {
    Hasher hasher;
    const scene::GBuffer gbuffer = stage.castGBuffer();
    add(hasher, gbuffer.light);
    project::Project project = stage.project;
    for (const char* method : {"view-aligned", "image-based"}) {
        project.method = method;
        const project::WornPaints worn{{&stage.paint, nullptr, glm::mat4(1)}};
        add(hasher, project::renderFrame(project, worn, gbuffer).frame.picture);
    }
    return hasher.value();
}

std::uint64_t save(const Stage& stage) {
    const test::TemporaryFolder folder;
    project::writeProject(folder / "a.chiaro", stage.project);
    writeImage(folder / "a.png", stage.strip);
    writeImage(folder / "a.exr", stage.strip);
    for (const char* name : {"a.obj", "a.glb"}) exporting::writeTexturedScene(folder / name, stage.textured);
    Hasher hasher;
    for (const char* name : {"a.png", "a.obj", "a.mtl", "a.glb"})
        hasher.add(std::string_view(readFile(folder / name, 1 << 24)));
    add(hasher, sample::readScan(folder / "a.exr"));  // without memory to compress it, it is stored as it is
    return hasher.value();
}

/// What came of a step.
struct Outcome {
    std::uint64_t result = 0;
    std::string error;   ///< empty when it succeeded
    bool isOurs = true;  ///< an error that the program has words for
    bool wasRefused = false;
    long allocations = 0;
};

Outcome runWithout(long number, Refused whose, const Step& step, const Stage& stage) {
    Outcome outcome;
    if (whose == Refused::Anybodys)
        keepMemoryReserve();
    else
        std::set_new_handler(nullptr);
    const RefusedAllocation refused(number, whose);
    try {
        outcome.result = step.run(stage);
    } catch (const std::bad_alloc&) {
        outcome.error = "no memory";
    } catch (const Error& error) {
        outcome.error = error.what();
    } catch (const std::exception& error) {
        outcome.error = error.what();
        outcome.isOurs = false;
    }
    outcome.allocations = refused.count();
    outcome.wasRefused = refused.hasRefused();
    return outcome;
}

std::set<long> numbersToRefuse(long allocations) {
    const bool isLong = std::getenv("CHIARO_LONG_TESTS") != nullptr;
    std::set<long> numbers;
    for (long k = 1; k <= std::min(isLong ? 2000L : 12L, allocations); ++k) numbers.insert(k);
    Random random(5, 0);
    for (int i = 0; i < (isLong ? 1000 : 50); ++i) {
        // Half of them early, where one step does most different things.
        const double share = i % 2 ? random.uniform() : random.uniform() * random.uniform();
        numbers.insert(1 + long(share * double(allocations - 1)));
    }
    return numbers;
}

/// Libraries keep what they make once; what grows every time is lost.
bool leaksWithout(long number, Refused whose, const Step& step, const Stage& stage) {
    for (int again = 0; again < 6; ++again) {
        const long before = test::heldBlocks();
        runWithout(number, whose, step, stage);
        if (test::heldBlocks() <= before) return false;
    }
    return true;
}

class RefusedMemory : public testing::TestWithParam<std::tuple<Step, Refused>> {};

TEST_P(RefusedMemory, IsAnErrorAndNothingElse) {
    // One thread, so that a number always means the same allocation.
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Stage stage;
    const auto& [step, whose] = GetParam();
    Outcome whole;
    for (int warm = 0; warm < 3; ++warm) whole = runWithout(0, whose, step, stage);
    ASSERT_EQ(whole.error, "");
    std::map<std::string, int> outcomes;
    for (const long number : numbersToRefuse(whole.allocations)) {
        std::cerr << "\r" << step.name << " " << number << " " << std::flush;  // told if it ends the program
        const long before = test::heldBlocks();
        const Outcome outcome = runWithout(number, whose, step, stage);
        const long grown = test::heldBlocks() - before;
        EXPECT_TRUE(outcome.isOurs) << number << ": " << outcome.error;
        EXPECT_TRUE(!outcome.error.empty() || outcome.result == whole.result) << number << ": another result";
        const bool leaks = grown > 0 && leaksWithout(number, whose, step, stage);
        // Libraries may lose their own: OpenImageIO does where libpng has no memory for a picture's head.
        if (leaks && whose == Refused::Anybodys) ++outcomes["lost by a library"];
        EXPECT_FALSE(leaks && whose == Refused::Ours) << number << ": " << outcome.error;
        ++outcomes[!outcome.wasRefused            ? "not ours"
                   : outcome.error.empty()        ? "succeeded all the same"
                   : outcome.error == "no memory" ? "no memory"
                                                  : "errors"];
    }
    std::cerr << "of " << whole.allocations << " allocations:";
    for (const auto& [outcome, count] : outcomes) std::cerr << " " << outcome << " " << count << ";";
    std::cerr << std::endl;
    const Outcome after = runWithout(0, whose, step, stage);
    EXPECT_EQ(after.error, "");
    EXPECT_EQ(after.result, whole.result);
}

std::string nameOf(const testing::TestParamInfo<std::tuple<Step, Refused>>& with) {
    const auto& [step, whose] = with.param;
    return std::string(step.name) + (whose == Refused::Ours ? "_ours" : "_anybodys");
}

INSTANTIATE_TEST_SUITE_P(Every, RefusedMemory,
                         testing::Combine(testing::Values(Step{"load", load}, Step{"separate", separate},
                                                          Step{"synthesise", synthesise},
                                                          Step{"render", render}, Step{"save", save}),
                                          testing::Values(Refused::Ours, Refused::Anybodys)),
                         nameOf);

}  // namespace
}  // namespace chiaro

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
