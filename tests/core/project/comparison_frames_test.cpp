#include "core/project/comparison_report.h"
#include "tests/core/scene/shapes.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace chiaro::test {
namespace {

project::Project smallProject() {
    project::Project project;
    project::Sample& sample = project.samples.emplace_back();
    sample.scan = resource("demo/samples/oil.png");
    project.levels.size = 64;
    project.levels.count = 3;
    project.levels.quilt.block = project.imageBased.quilt.block = 16;
    project.levels.quilt.overlap = project.imageBased.quilt.overlap = 4;
    project.views.size = 96;
    project.views.count = 4;
    return project;
}

project::ComparisonParams smallParams(int seeds) {
    project::ComparisonParams params;
    params.width = params.height = 96;
    params.frames = 3;
    params.seeds = seeds;
    params.measure.pixels = 30;
    return params;
}

TEST(ComparisonFrames, TheTableIsTheMeanOverItsFrames) {
    const project::Project project = smallProject();
    const auto table =
        project::compareMethods(project, sceneOf({ball(48, 24)}), scene::Path::turntable(24), smallParams(2));
    ASSERT_EQ(table.size(), 3u);
    for (const project::MethodMeasure& method : table) {
        ASSERT_EQ(method.perFrame.size(), 3u) << method.method;
        EXPECT_EQ(method.perFrame[0].temporalImage.count, 0u);
        EXPECT_EQ(method.perFrame[0].temporalObject.count, 0u);
        for (const project::ComparedError& error : project::comparedErrors()) {
            double sum = 0;
            std::size_t count = 0;
            for (const project::MeasuredErrors& frame : method.perFrame) {
                const metrics::Estimate& one = frame.*error.measured;
                sum += one.mean * double(one.count);
                count += one.count;
            }
            EXPECT_EQ((method.*error.measured).count, count) << method.method << " " << error.name;
            EXPECT_NEAR((method.*error.measured).mean, sum / double(count), 1e-12)
                << method.method << " " << error.name;
        }
    }
    const std::string csv = project::framesCsv(table);
    // Three methods; three errors in three frames, two between them in two.
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3 * (3 * 3 + 2 * 2));
    EXPECT_EQ(csv.find("1,\"Temporal"), std::string::npos);
    EXPECT_NE(csv.find("\n2,\"Temporal, image space\",view-aligned,"), std::string::npos);
}

TEST(ComparisonFrames, ACancelledComparisonEndsWithoutAResult) {
    const project::Project project = smallProject();
    std::stop_source stop;
    double reached = 0;
    const Task task(stop.get_token(), [&](double fraction) {
        reached = fraction;
        if (fraction > 0.2) stop.request_stop();
    });
    EXPECT_THROW(project::compareMethods(project, sceneOf({ball(48, 24)}), scene::Path::turntable(24),
                                         smallParams(5), task),
                 Cancelled);
    EXPECT_GT(reached, 0.2);
    EXPECT_LT(reached, 0.6);
}

TEST(ComparisonFrames, TheReportsFiguresAreKnownByMethod) {
    const auto errors = project::comparedErrors();
    const auto similarity =
        std::ranges::find(errors, &project::MeasuredErrors::similarity, &project::ComparedError::measured);
    const auto object = std::ranges::find(errors, &project::MeasuredErrors::temporalObject,
                                          &project::ComparedError::measured);
    ASSERT_NE(similarity, errors.end());
    ASSERT_NE(object, errors.end());
    EXPECT_DOUBLE_EQ(project::reportedError(*similarity, "view-dependent").value(), 0.10197);
    EXPECT_FALSE(project::reportedError(*similarity, "another"));
    EXPECT_FALSE(project::reportedError(*object, "image-based"));
}

}  // namespace
}  // namespace chiaro::test
