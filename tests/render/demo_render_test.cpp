#include "core/base/image_io.h"
#include "core/methods/method.h"
#include "core/project/pipeline.h"
#include "core/sample/strip.h"
#include "core/scene/mesh_io.h"
#include "tests/support/support.h"

#include <cstdlib>

namespace chiaro::test {
namespace {

namespace fs = std::filesystem;

/// Mean absolute difference of 8-bit pictures that another machine's rounding may cause: a few pixels along
/// silhouettes.
constexpr double largestMeanDifference = 1.0 / 255;

struct Render {
    const char* name;    ///< of the baseline
    const char* mesh;    ///< in resources/demo/meshes
    const char* sample;  ///< in resources/demo/samples
    const char* method = "view-aligned";
};

void PrintTo(const Render& render, std::ostream* stream) {
    *stream << render.name;
}

class DemoRender : public testing::TestWithParam<Render> {};

ColorImage paint(const Render& render) {
    project::Project project;
    project.meshes = {{resource(std::string("demo/meshes/") + render.mesh)}};
    project.samples.emplace_back().scan = resource(std::string("demo/samples/") + render.sample);
    project.method = render.method;
    project.levels.size = project.views.size = 256;
    project::MeshList meshes;
    for (const scene::Mesh& mesh : scene::readModel(project.meshes[0].path).meshes)
        meshes.push_back(std::make_shared<const scene::Mesh>(mesh));
    const scene::Scene scene = project::makeScene(project, {meshes});
    const scene::GBuffer gbuffer = scene::castGBuffer(scene::RayScene(scene), scene.lights,
                                                      project::cameraFor(project, scene), 320, 320);
    const std::vector<project::Paint> made{project::preparePaint(project, 0)};
    const project::WornPaints worn = project::wornPaints(project, scene, made);
    return methods::over(project::renderFrame(project, worn, gbuffer).frame.picture, glm::vec3(1));
}

double meanDifference(const ColorImage& a, const ColorImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixelCount(); ++i) {
        const glm::vec3 difference = glm::abs(a.pixels()[i] - b.pixels()[i]);
        sum += double(difference.r + difference.g + difference.b) / 3;
    }
    return sum / double(a.pixelCount());
}

TEST_P(DemoRender, LooksAsItDid) {
    const ColorImage picture = paint(GetParam());
    const std::string file = std::string(GetParam().name) + ".png";
    const fs::path baseline = fs::path(CHIARO_BASELINES) / file;
    if (std::getenv("CHIARO_WRITE_BASELINES")) writeImage(baseline, picture);
    const ColorImage expected = sample::readScan(baseline);
    ASSERT_EQ(expected.width(), picture.width());
    ASSERT_EQ(expected.height(), picture.height());
    const double difference = meanDifference(picture, expected);
    if (difference > largestMeanDifference) writeImage(file, picture);
    EXPECT_LE(difference, largestMeanDifference) << "the picture was kept as " << fs::absolute(file);
}

INSTANTIATE_TEST_SUITE_P(
    Demo, DemoRender,
    testing::Values(Render{"skull_oil", "skull.glb", "oil.png"},
                    Render{"skull_charcoal", "skull.glb", "charcoal.png"},
                    Render{"skull_hatching", "skull.glb", "hatching.png"},
                    Render{"still_life_pastel", "still_life.obj", "pastel.png"},
                    Render{"shell_watercolour", "shell.ply", "watercolour.png"},
                    Render{"shell_impasto", "shell.ply", "impasto.png"},
                    Render{"skull_oil_image_based", "skull.glb", "oil.png", "image-based"},
                    Render{"still_life_hatching_image_based", "still_life.obj", "hatching.png",
                           "image-based"},
                    Render{"skull_charcoal_view_dependent", "skull.glb", "charcoal.png", "view-dependent"},
                    Render{"shell_oil_view_dependent", "shell.ply", "oil.png", "view-dependent"}),
    [](const auto& render) { return std::string(render.param.name); });

}  // namespace
}  // namespace chiaro::test
