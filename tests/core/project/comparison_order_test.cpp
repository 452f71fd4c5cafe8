#include "core/base/error.h"
#include "core/project/comparison.h"
#include "core/scene/mesh_io.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace chiaro::test {
namespace {

using metrics::Estimate;
using project::MeasuredErrors;

/// The demo's skull in one of the demo's strips.
struct Demo {
    explicit Demo(const char* strip) : settings(project::readProject(resource("demo/demo.chiaro"))) {
        for (project::Sample& sample : settings.samples) sample.scan = resource(strip);
        std::vector<std::shared_ptr<const scene::Mesh>> meshes;
        for (const scene::Mesh& mesh : scene::readModel(settings.meshes.at(0).path).meshes)
            meshes.push_back(std::make_shared<const scene::Mesh>(mesh));
        scene = project::makeScene(settings, {meshes});
    }
    project::Project settings;
    scene::Scene scene;
};

/// Smaller by more than chance explains.
void expectBelow(const Estimate& smaller, const Estimate& larger, const char* what) {
    EXPECT_LT(smaller.mean + 2 * std::hypot(smaller.standardError, larger.standardError), larger.mean)
        << what;
}

TEST(ComparisonOrder, IsThatOfTheReportsTable) {
    const Demo demo("demo/samples/oil.png");
    project::ComparisonParams params;
    params.frames = 3;
    params.seeds = 1;
    params.measure.pixels = 1000;
    std::map<std::string, MeasuredErrors> errors;
    for (const project::MethodMeasure& method : project::compareMethods(
             project::animatedAsReported(demo.settings), demo.scene, scene::Path::approaching(), params))
        errors[method.method] = method;
    const MeasuredErrors &image = errors.at("image-based"), &aligned = errors.at("view-aligned"),
                         &dependent = errors.at("view-dependent");
    expectBelow(image.similarity, aligned.similarity, "similarity");
    expectBelow(aligned.similarity, dependent.similarity, "similarity");
    expectBelow(aligned.temporalImage, image.temporalImage, "image space");
    expectBelow(aligned.temporalImage, dependent.temporalImage, "image space");
    expectBelow(dependent.temporalObject, image.temporalObject, "object space");
    expectBelow(dependent.temporalObject, aligned.temporalObject, "object space");
}

TEST(ComparisonOrder, SaysWhenFramesShowTooLittle) {
    Demo demo("demo/samples/oil.png");
    demo.settings.camera.distance = 90;
    project::ComparisonParams params;
    params.width = params.height = 64;
    params.frames = 2;
    params.seeds = 1;
    demo.settings.levels.size = demo.settings.views.size = 64;
    try {
        project::compareMethods(demo.settings, demo.scene, scene::Path::approaching(), params);
        FAIL();
    } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("frames: show nothing on which a block fits"))
            << error.what();
    }
}

}  // namespace
}  // namespace chiaro::test
