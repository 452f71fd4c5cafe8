#include "tests/bench/page/figures.h"

#include <fmt/format.h>

namespace chiaro::bench {

namespace {

Reading methods(std::string benchmark, std::string figure = "real_time") {
    return {"methods", std::move(benchmark), std::move(figure)};
}
Reading project(std::string benchmark, std::string figure = "real_time") {
    return {"project", std::move(benchmark), std::move(figure)};
}
Reading views(std::string benchmark, std::string figure = "real_time") {
    return {"views", std::move(benchmark), std::move(figure)};
}
Reading metrics(std::string benchmark, std::string figure = "real_time") {
    return {"metrics", std::move(benchmark), std::move(figure)};
}
Reading viewport(std::string benchmark, std::string figure = "processor_ratio") {
    return {"viewport", std::move(benchmark), std::move(figure)};
}
const Reading nothing{};

Section synthesis() {
    const std::string peer = "againstMatchTemplate/{simd}", frame = "frame/{simd}/width:";
    return {
        "Image-based synthesis",
        "A ball that fills most of the picture, painted from an 800 x 200 strip in blocks of 32 pixels, "
        "shading "
        "included. The peer is the same quilting with `cv::matchTemplate`, the search that OpenCV users "
        "write, "
        "on one core; *less work* compares the time of all cores. The bound is what a core multiplies and "
        "adds "
        "in the search's own instructions when it does nothing else.",
        {{"512 x 512", Unit::Milliseconds, methods(frame + "512/height:512"), nothing, Goal::AtMost, 60},
         {"faster than `cv::matchTemplate`", Unit::Times, methods(peer, "faster"), nothing, Goal::AtLeast,
          50},
         {"less work than `cv::matchTemplate`", Unit::Times, methods(peer, "less_work"), nothing,
          Goal::AtLeast, 30},
         {"its error over that of `cv::matchTemplate`", Unit::Times, methods(peer, "error"), nothing,
          Goal::AtMost, 1.02},
         {"of a core's multiply-adds", Unit::Percent, methods("multiplyAdds/{simd}", "share"), nothing,
          Goal::AtLeast, 60},
         {"draft of 512 x 512, faster than the fine picture", Unit::Times, methods(peer, "draft_faster"),
          methods(peer, "faster"), Goal::AtLeast, 2},
         {"error of a draft over the fine picture's", Unit::Times, methods(peer, "draft_error"), nothing,
          Goal::AtMost, 1.1},
         {"1920 x 1080", Unit::Milliseconds, methods(frame + "1920/height:1080"), nothing, Goal::AtMost, 300},
         {"2048 x 2048", Unit::Milliseconds, methods(frame + "2048/height:2048"), nothing, Goal::None, 0},
         {"light or colour changed, 1920 x 1080", Unit::Milliseconds, methods("shade/best"), nothing,
          Goal::AtMost, 50},
         {"of the memory's speed while shading",
          Unit::Percent,
          methods("shade/best", "bytes_per_second"),
          {"base", "triadOnAllThreads", "bytes_per_second"},
          Goal::None,
          0},
         {"time grows with the covered pixels to the power", Unit::Number, methods("growth/{simd}", "slope"),
          nothing, Goal::AtMost, 1.1},
         {"level stack of a strip",
          Unit::Milliseconds,
          {"synthesis", "levels/{simd}"},
          nothing,
          Goal::None,
          0},
         {"the same, faster than with `cv::matchTemplate`",
          Unit::Times,
          {"synthesis", "levels/matchTemplate"},
          {"synthesis", "levels/{simd}"},
          Goal::AtLeast,
          20}}};
}

Section animation() {
    return {
        "Animation",
        "A turntable of 48 frames of the demo skull, 512 x 512, image-based; the ways in which frames hang "
        "together differ in cost.",
        {{"each frame on its own", Unit::Seconds, project("turntable/independent"), nothing, Goal::None, 0},
         {"keeping to the frame before", Unit::Seconds, project("turntable/previous"), nothing, Goal::None,
          0},
         {"key frames, blended", Unit::Seconds, project("turntable/keyframes"), nothing, Goal::AtMost, 4},
         {"reprojected", Unit::Seconds, project("turntable/reprojected"), nothing, Goal::None, 0}}};
}

Section viewDependent() {
    const std::string many = "ManyFacesPlan/balls:22";
    return {
        "View-dependent textures and export",
        "The demo skull in the demo oil with twelve views; half a million faces are bumpy balls when views "
        "are planned, and one ball when it is exported.",
        {{"faces that 12 views of the skull show", Unit::Milliseconds, views("HeadVisibility"), nothing,
          Goal::AtMost, 1000},
         {"views of the skull planned", Unit::Milliseconds, views("HeadPlan"), nothing, Goal::None, 0},
         {"views of half a million faces planned", Unit::Seconds, views(many), nothing, Goal::AtMost, 10},
         {"textures of the skull", Unit::Seconds, project("textures/views:12"), nothing, Goal::AtMost, 10},
         {"the same from the cache", Unit::Seconds, project("texturesFromCache"), nothing, Goal::AtMost, 2},
         {"export with an atlas of 2048", Unit::Seconds, project("skullAfterSynthesis"), nothing,
          Goal::AtMost, 3},
         {"half a million faces painted and exported", Unit::Seconds, project("halfAMillionFaces"), nothing,
          Goal::AtMost, 30}}};
}

Section viewportFrames() {
    return {
        "The viewport",
        "A frame of 1280 x 720 over the same mesh under one plain 2D texture, in the same context with the "
        "same samples a pixel, frames interleaved. Ratios of processor time: a software renderer's clock "
        "times depend on what else runs.",
        {{"view-aligned", Unit::Times, viewport("viewAligned"), nothing, Goal::AtMost, 1.5},
         {"view-aligned between two octaves", Unit::Times, viewport("viewAlignedTwoOctaves"), nothing,
          Goal::None, 0},
         {"image-based", Unit::Times, viewport("imageBased"), nothing, Goal::AtMost, 1.5},
         {"view-dependent", Unit::Times, viewport("viewDependent"), nothing, Goal::AtMost, 2.2},
         {"view-dependent, following the camera", Unit::Times, viewport("viewDependentFollowing"), nothing,
          Goal::None, 0},
         {"a view-aligned frame", Unit::Milliseconds, viewport("viewAligned", "real_time"), nothing,
          Goal::None, 0}}};
}

Section metricSearch() {
    return {"The metric",
            "Exact nearest neighbours of descriptors of 8 x 8 pixels in a strip of 800 x 200. The peer is a "
            "plain scan of all descriptors as a compiler vectorises it, on one thread like ours.",
            {{"100 pixels", Unit::Milliseconds, metrics("Nearest/8"), nothing, Goal::AtMost, 25},
             {"faster than the plain scan", Unit::Times, metrics("PlainLoop/8", "cpu_time"),
              metrics("Nearest/8", "cpu_time"), Goal::AtLeast, 50},
             {"its index, once a strip", Unit::Milliseconds, metrics("Index/8"), nothing, Goal::None, 0},
             {"every pixel of 512 x 512, all threads", Unit::Seconds, metrics("EveryPixel"), nothing,
              Goal::AtMost, 20}}};
}

/// A row that is left out where its program was not run.
Figure whereRun(Figure figure) {
    figure.isOptional = true;
    return figure;
}

/// How much longer the helper process takes to read a file.
Figure inHelper(std::string what, std::string benchmark) {
    return whereRun({std::move(what) + " read in the helper process, longer by",
                     Unit::Milliseconds,
                     {"import", std::move(benchmark)},
                     nothing,
                     Goal::AtMost,
                     50});
}

Section program() {
    return {"The programs",
            "What a user waits for before anything is shown.",
            {whereRun({"the studio's start to its window",
                       Unit::Seconds,
                       {"studio", "start"},
                       nothing,
                       Goal::AtMost,
                       1}),
             inHelper("a picture of 4096 x 4096", "PNG_4096_x_4096"),
             inHelper("a mesh of 500,000 triangles", "PLY_500_000_triangles"),
             inHelper("the demo's strip", "PNG_the_demo's_strip"),
             {"G-buffer of half a million faces, 1024 x 1024",
              Unit::Milliseconds,
              {"scene", "Cast"},
              nothing,
              Goal::None,
              0},
             {"its acceleration structure, once a scene",
              Unit::Milliseconds,
              {"scene", "Build"},
              nothing,
              Goal::None,
              0}}};
}

Section memory() {
    return {"Peak memory",
            "Of the whole process, its program and libraries included.",
            {{"image-based picture of 4096 x 4096", Unit::Gigabytes, methods("memory/4096", "memory"),
              nothing, Goal::AtMost, 1},
             {"views of half a million faces planned", Unit::Megabytes,
              views("ManyFacesPlan/balls:22", "memory"), nothing, Goal::AtMost, 500},
             {"textures of the skull", Unit::Megabytes, project("textures/views:12", "memory"), nothing,
              Goal::None, 0},
             {"half a million faces painted and exported", Unit::Gigabytes,
              project("halfAMillionFaces", "memory"), nothing, Goal::AtMost, 3}}};
}

Section machine() {
    return {
        "The machine",
        "What bounds all of this: the memory's speed by the triad a = b + 3 c over arrays far larger than "
        "the caches, and what a core multiplies and adds in a second of its time, in bytes.",
        {{"triad on one thread",
          Unit::GigabytesASecond,
          {"base", "triad/threads:1", "bytes_per_second"},
          nothing,
          Goal::None,
          0},
         {"triad on all threads",
          Unit::GigabytesASecond,
          {"base", "triadOnAllThreads", "bytes_per_second"},
          nothing,
          Goal::None,
          0},
         {"multiply-adds of a core", Unit::GigaOperations, methods("multiplyAdds/{simd}", "core_peak"),
          nothing, Goal::None, 0}}};
}

double unitsIn(Unit unit) {
    switch (unit) {
        case Unit::Milliseconds:
            return 1e3;
        case Unit::Percent:
            return 100;
        case Unit::Megabytes:
            return 1e-6;
        case Unit::Gigabytes:
        case Unit::GigabytesASecond:
        case Unit::GigaOperations:
            return 1e-9;
        default:
            return 1;
    }
}

}  // namespace

const std::vector<Section>& sections() {
    static const std::vector<Section> all{synthesis(),    animation(), viewDependent(), viewportFrames(),
                                          metricSearch(), program(),   memory(),        machine()};
    return all;
}

std::optional<double> measured(const Figure& figure, const Results& results) {
    std::optional<double> value = results.find(figure.value);
    if (value && !figure.over.program.empty()) {
        const std::optional<double> over = results.find(figure.over);
        if (!over || !(*over > 0)) return std::nullopt;
        *value /= *over;
    }
    if (value) *value *= unitsIn(figure.unit);
    return value;
}

std::string inWords(double value, Unit unit) {
    const auto number = [&] {
        if (value >= 100) return fmt::format("{:.0f}", value);
        return fmt::format("{:.3g}", value);
    };
    switch (unit) {
        case Unit::Milliseconds:
            return number() + " ms";
        case Unit::Seconds:
            return number() + " s";
        case Unit::Times:
            return number() + " x";
        case Unit::Percent:
            return number() + " %";
        case Unit::Megabytes:
            return number() + " MB";
        case Unit::Gigabytes:
            return number() + " GB";
        case Unit::GigabytesASecond:
            return number() + " GB/s";
        case Unit::GigaOperations:
            return number() + " G/s";
        default:
            return number();
    }
}

}  // namespace chiaro::bench
