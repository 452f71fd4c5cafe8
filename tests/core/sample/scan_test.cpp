#include "core/base/color.h"
#include "core/base/error.h"
#include "core/base/image_io.h"
#include "core/sample/strip.h"
#include "tests/support/support.h"

namespace chiaro::sample {
namespace {

using namespace test;

TEST(Scan, KeepsEightBitValues) {
    const TemporaryFolder folder;
    ColorImage image(4, 2, {10 / 255.0f, 20 / 255.0f, 30 / 255.0f});
    writeImage(folder / "a.png", image);
    EXPECT_EQ(readScan(folder / "a.png"), image);
}

TEST(Scan, GreyBecomesRgb) {
    const TemporaryFolder folder;
    writeImage(folder / "a.png", ScalarImage(4, 2, 51 / 255.0f));
    EXPECT_EQ(readScan(folder / "a.png"), ColorImage(4, 2, glm::vec3(51 / 255.0f)));
}

TEST(Scan, PaperShowsThroughAlpha) {
    const TemporaryFolder folder;
    ColorAlphaImage image(3, 1, {1, 0, 0, 1});
    image(1, 0) = {0, 0, 1, 0};
    image(2, 0) = {0, 1, 0, 51 / 255.0f};
    writeImage(folder / "a.png", image);
    const ColorImage scan = readScan(folder / "a.png");
    EXPECT_EQ(scan(0, 0), glm::vec3(1, 0, 0));
    EXPECT_EQ(scan(1, 0), glm::vec3(1));
    EXPECT_NEAR(scan(2, 0).r, 0.8, 1e-6);
    EXPECT_NEAR(scan(2, 0).g, 1, 1e-6);
}

TEST(Scan, LinearFilesAreEncodedAndClipped) {
    const TemporaryFolder folder;
    ColorImage image(2, 1, linearFromSrgb(glm::vec3(0.2f, 0.5f, 0.8f)));
    image(1, 0) = {-0.5f, 7.0f, 1.0f};
    writeImage(folder / "a.exr", image);
    const ColorImage scan = readScan(folder / "a.exr");
    EXPECT_NEAR(scan(0, 0).r, 0.2, 1e-6);
    EXPECT_NEAR(scan(0, 0).g, 0.5, 1e-6);
    EXPECT_NEAR(scan(0, 0).b, 0.8, 1e-6);
    EXPECT_EQ(scan(1, 0).r, 0);
    EXPECT_EQ(scan(1, 0).g, 1);
    EXPECT_NEAR(scan(1, 0).b, 1, 1e-6);
}

TEST(Scan, RealScansHaveTheirDocumentedSize) {
    CHIARO_NEEDS_SHARED_DATA();
    const auto samples = sharedData() / "samples";
    const auto size = [&](const char* name) {
        const ColorImage scan = readScan(samples / name);
        return std::pair(scan.width(), scan.height());
    };
    EXPECT_EQ(size("wc_purple_10_exif6.jpg"), std::pair(563, 112)) << "stored on its side";
    EXPECT_EQ(size("wc_orange_09_16bit.tif"), std::pair(1074, 165));
    EXPECT_EQ(size("ünï codé/пастель 画.jpg"), std::pair(868, 132));
    EXPECT_EQ(size("stroke_alpha_reversed.png"), std::pair(1024, 256));
}

TEST(Scan, TransparentPixelsOfARealStrokeArePaper) {
    CHIARO_NEEDS_SHARED_DATA();
    const ColorImage scan = readScan(sharedData() / "samples" / "stroke_alpha_reversed.png");
    EXPECT_EQ(scan(1023, 0), glm::vec3(1));
}

}  // namespace
}  // namespace chiaro::sample
