#include "core/base/atomic_file.h"
#include "core/base/image_io.h"
#include "tests/cli/program.h"
#include "tests/support/support.h"

namespace chiaro::test {
namespace {

const std::string oil = resource("demo/samples/oil.png").string();
const std::string skull = resource("demo/meshes/skull.glb").string();

Outcome measure(const std::string& picture, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"measure", "--sample", oil, picture, "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return chiaro(arguments);
}

/// A part of the strip.
ColorImage partOf(const DecodedImage& image, int left, int width, int height) {
    ColorImage part(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                part(x, y)[c] = image.values[std::size_t((y * image.width + left + x) * image.channels + c)];
    return part;
}

TEST(Measure, ASampleAgainstItselfIsZeroAndWhatIsNotGivenIsNull) {
    const Outcome outcome = measure(oil, {});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const nlohmann::json json = outcome.json();
    EXPECT_EQ(json["pixels"], 100);
    EXPECT_EQ(json["similarity"], 0);
    for (const char* key : {"shading_mae", "shading_mse", "temporal_image", "temporal_object"}) {
        ASSERT_TRUE(json.contains(key)) << key;
        EXPECT_TRUE(json[key].is_null()) << key;
    }
}

TEST(Measure, FramesOfAnAnimationGiveEveryNumber) {
    const TemporaryFolder folder;
    ASSERT_EQ(chiaro({"animate", "--mesh", skull, "--sample", oil, "--method", "image-based", "--size",
                      "160x160", "--frames", "1-2", "--coherence", "reprojected", "-o", folder / "a.####.png",
                      "--aux", folder / "aux"})
                  .status,
              0);
    const std::vector<std::string> flags{
        "--light",  folder / "aux/light.0001.exr",  "--mask",      folder / "aux/id.0001.png",
        "--next",   folder / "a.0002.png",          "--next-mask", folder / "aux/id.0002.png",
        "--motion", folder / "aux/motion.0001.exr", "--pixels",    "60"};
    const Outcome outcome = measure(folder / "a.0001.png", flags);
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const nlohmann::json json = outcome.json();
    EXPECT_EQ(json["pixels"], 60);
    EXPECT_GT(json["similarity"], 0.02);
    EXPECT_LT(json["similarity"], 0.5);
    EXPECT_LT(json["shading_mae"], 0.2);
    EXPECT_LT(json["shading_mse"], json["shading_mae"]);
    // Reprojected strokes stick to the object, which turns.
    EXPECT_LT(json["temporal_object"], 0.8 * json["temporal_image"].get<double>());
    std::vector<std::string> other = flags;
    other.insert(other.end(), {"--threads", "1"});
    nlohmann::json again = measure(folder / "a.0001.png", other).json();
    again["seconds"] = json["seconds"];
    EXPECT_EQ(again, json);
    other.insert(other.end(), {"--seed", "2"});
    EXPECT_NE(measure(folder / "a.0001.png", other).json()["similarity"], json["similarity"]);
}

TEST(Measure, MapsTellEveryPixel) {
    const TemporaryFolder folder;
    const ColorImage part = partOf(readImage(oil), 300, 60, 40);
    writeImage(folder / "part.png", part);
    const Outcome outcome = measure(folder / "part.png", {"--pixels", "all", "--heatmap", folder / "h.exr",
                                                          "--matches", folder / "m.png"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.json()["pixels"], 53 * 33);
    const DecodedImage map = readImage(folder / "h.exr");
    ASSERT_EQ(map.width, 60);
    EXPECT_EQ(map.values[0], -1);
    EXPECT_EQ(map.values[20 * 60 + 30], 0);  // away from the border it is the strip itself
    EXPECT_EQ(readImage(folder / "m.png").width, 60);
    ASSERT_EQ(measure(folder / "part.png", {"--heatmap", folder / "h.png"}).status, 0);
    EXPECT_GT(readImage(folder / "h.png").width, 60);  // with a bar
}

TEST(Measure, TheStudyWritesItsCurves) {
    const TemporaryFolder folder;
    const Outcome outcome =
        chiaro({"measure", "study", "--sample", oil, "-o", folder / "study", "--pixels", "5", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.json()["points"], 4 * 3 * (13 + 27 + 8));
    const std::string csv = readFile(folder / "study/study.csv", 1 << 20);
    for (const std::string texture : {"random", "diagonal", "symmetric", "oil"})
        EXPECT_NE(csv.find(texture + ",scale-both,12,2,"), std::string::npos) << texture;
    for (const char* name : {"rotation.svg", "scale.svg", "discontinuity.svg", "rotation.png", "scale.png",
                             "discontinuity.png", "distortions.png"})
        EXPECT_TRUE(std::filesystem::exists(folder / "study" / name)) << name;
}

TEST(Measure, RefusesWhatItCannotDoInOneSentence) {
    const TemporaryFolder folder;
    writeImage(folder / "plain.png", ColorImage(80, 40, glm::vec3(0.4f)));
    writeImage(folder / "tiny.png", ColorImage(7, 7, glm::vec3(0.4f)));
    writeImage(folder / "nowhere.png", IdImage(80, 40, 0));
    struct Case {
        std::vector<std::string> arguments;
        int status;
        const char* says;
    };
    for (const Case& one : std::vector<Case>{
             {{"measure"}, 2, "PICTURE"},
             {{"measure", folder / "plain.png"}, 2, "--sample"},
             {{"measure", "--sample", oil, folder / "plain.png", "--pixels", "some"}, 2, "some"},
             {{"measure", "--sample", oil, folder / "plain.png", "--block", "3"}, 2, "block"},
             {{"measure", "--sample", oil, folder / "plain.png", "--motion", "m.exr"}, 2, "--next"},
             {{"measure", "--sample", oil, folder / "none.png"}, 1, "none.png"},
             {{"measure", "--sample", folder / "plain.png", oil}, 1, "one colour"},
             {{"measure", "--sample", oil, folder / "tiny.png"}, 1, "7 x 7 pixels, smaller than a block"},
             {{"measure", "--sample", oil, folder / "plain.png", "--mask", folder / "nowhere.png"},
              1,
              "no pixel"},
             {{"measure", "--sample", oil, oil, "--mask", folder / "nowhere.png"}, 1, "80 x 40"},
             {{"measure", "--sample", oil, oil, "--next", oil, "--motion", oil}, 1, "OpenEXR"},
             {{"measure", "--sample", oil, oil, "--heatmap", oil}, 1, "input"},
             {{"measure", "study", "--sample", oil}, 2, "--output"},
             {{"measure", "study", "--sample", folder / "plain.png", "-o", folder / "s"}, 1, "plain"},
             {{"compare", resource("demo/demo.chiaro").string(), "--sample", folder / "plain.png", "-o",
               folder / "c", "--size", "64x64"},
              1,
              "plain.png"}}) {
        const Outcome outcome = chiaro(one.arguments);
        EXPECT_EQ(outcome.status, one.status) << outcome.error;
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
        EXPECT_NE(outcome.error.find(one.says), std::string::npos) << outcome.error;
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "s"));
}

}  // namespace
}  // namespace chiaro::test
