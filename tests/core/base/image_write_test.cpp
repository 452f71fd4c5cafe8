#include "core/base/error.h"
#include "core/base/image_io.h"
#include "tests/core/base/raw_files.h"
#include "tests/support/support.h"

#include <limits>

namespace chiaro {
namespace {

using namespace test;

class ImageWrite : public testing::Test {
protected:
    TemporaryFolder m_folder;
};

TEST_F(ImageWrite, RoundsHalvesUpAndClips) {
    ScalarImage image(6, 1);
    const float values[] = {-1,           0.5f / 255, 0.4999f / 255,
                            127.5f / 255, 2,          std::numeric_limits<float>::quiet_NaN()};
    std::copy(std::begin(values), std::end(values), image.pixels().begin());
    writeImage(m_folder / "eight.png", image);
    const std::vector<float> eight{0, 1 / 255.0f, 0, 128 / 255.0f, 1, 0};
    EXPECT_EQ(readImage(m_folder / "eight.png").values, eight);
}

TEST_F(ImageWrite, EveryLevelSurvives) {
    ColorImage image(256, 256);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            image(x, y) = {float(x) / 255.0f, float(y) / 255.0f, float(x * 256 + y) / 65535.0f};
    for (const char* name : {"deep.png", "deep.tif"}) {
        writeImage(m_folder / name, image, {}, PixelDepth::Bits16);
        const DecodedImage read = readImage(m_folder / name);
        ASSERT_EQ(read.channels, 3);
        for (std::size_t i = 0; i < image.pixelCount(); ++i) {
            ASSERT_EQ(read.values[3 * i], image.pixels()[i].r) << name;
            ASSERT_EQ(read.values[3 * i + 2], image.pixels()[i].b) << name;
        }
    }
}

TEST_F(ImageWrite, ExrHoldsFloatsAsGiven) {
    ColorImage image(2, 1);
    image(0, 0) = {-0.75f, 1e-7f, 3.5f};
    image(1, 0) = {0.1f, 0.2f, 0.3f};
    writeImage(m_folder / "float.exr", image);
    const DecodedImage read = readImage(m_folder / "float.exr");
    EXPECT_TRUE(read.linear);
    EXPECT_EQ(read.values, (std::vector<float>{-0.75f, 1e-7f, 3.5f, 0.1f, 0.2f, 0.3f}));
    writeImage(m_folder / "grey.exr", ScalarImage(3, 2, -1.0f));
    EXPECT_EQ(readImage(m_folder / "grey.exr").values, std::vector<float>(6, -1.0f));
}

TEST_F(ImageWrite, CoverageIsNotPremultiplied) {
    const ColorAlphaImage image(2, 2, {1.0f, 0.4f, 0.2f, 0.2f});
    for (const char* name : {"alpha.png", "alpha.tif", "alpha.exr"}) {
        writeImage(m_folder / name, image);
        const DecodedImage read = readImage(m_folder / name);
        ASSERT_EQ(read.channels, 4) << name;
        for (int channel = 0; channel < 4; ++channel)
            EXPECT_NEAR(read.values[std::size_t(channel)], image(0, 0)[channel], 1e-6) << name;
    }
}

TEST_F(ImageWrite, JpegShowsCoverageOverWhite) {
    writeImage(m_folder / "flat.jpg", ColorAlphaImage(16, 16, {0, 0, 0, 0.25f}));
    const DecodedImage read = readImage(m_folder / "flat.jpg");
    ASSERT_EQ(read.channels, 3);
    EXPECT_NEAR(read.values[0], 0.75, 2.0 / 255);
}

TEST_F(ImageWrite, IdsStayWhatTheyAre) {
    IdImage ids(3, 1);
    ids(1, 0) = 7;
    writeImage(m_folder / "few.png", ids);
    EXPECT_EQ(readImage(m_folder / "few.png").values, (std::vector<float>{0, 7 / 255.0f, 0}));
    ids(2, 0) = 300;
    writeImage(m_folder / "many.png", ids);
    EXPECT_EQ(readImage(m_folder / "many.png").values, (std::vector<float>{0, 7 / 65535.0f, 300 / 65535.0f}));
    EXPECT_THROW(writeImage(m_folder / "ids.jpg", ids), Error);
}

TEST_F(ImageWrite, MetadataCanBeReadBack) {
    const ImageMetadata metadata{{"Software", "Chiaro 0.1.0"},
                                 {"Command", "chiaro render --sample 'ünï: x.png'"},
                                 {"Parameters", "{\"block\": 32}"}};
    for (const char* name : {"m.png", "m.tif", "m.jpg", "m.exr"}) {
        writeImage(m_folder / name, ColorImage(8, 8, glm::vec3(0.5f)), metadata);
        const ImageMetadata read = readImageMetadata(m_folder / name);
        for (const auto& [key, value] : metadata) {
            ASSERT_TRUE(read.contains(key)) << name << " " << key;
            EXPECT_EQ(read.at(key), value) << name;
        }
        EXPECT_FALSE(read.contains("DateTime")) << name;
    }
}

TEST_F(ImageWrite, TheSameInputGivesTheSameBytes) {
    ColorImage image(100, 80);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) image.pixels()[i] = glm::vec3(float(i % 97) / 97.0f);
    for (const char* extension : {".png", ".tif", ".jpg", ".exr"}) {
        writeImage(m_folder / (std::string("a") + extension), image, {{"Software", "Chiaro"}});
        writeImage(m_folder / (std::string("b") + extension), image, {{"Software", "Chiaro"}});
        EXPECT_EQ(load(m_folder / (std::string("a") + extension)),
                  load(m_folder / (std::string("b") + extension)));
    }
}

TEST_F(ImageWrite, RefusesUnknownExtensionsAndEmptyPictures) {
    EXPECT_TRUE(isWritableImage("a/b.PNG"));
    EXPECT_FALSE(isWritableImage("a/b.gif"));
    EXPECT_FALSE(isWritableImage("png"));
    EXPECT_THROW(writeImage(m_folder / "a.gif", ColorImage(4, 4)), Error);
    EXPECT_THROW(writeImage(m_folder / "a.png", ColorImage()), Error);
    EXPECT_TRUE(filesIn(m_folder.path()).empty());
}

TEST_F(ImageWrite, LeavesTheOldFileWhenTheFolderRefuses) {
    save(m_folder / "file", "old");
    EXPECT_THROW(writeImage(m_folder / "file/picture.png", ColorImage(4, 4)), Error);
    EXPECT_EQ(load(m_folder / "file"), "old");
}

TEST_F(ImageWrite, VectorsComeBackAsTheyWere) {
    Image<glm::vec2> vectors(3, 2, glm::vec2(0.25f, -8));
    vectors(1, 0) = {-3, 0};
    vectors(2, 1) = glm::vec2(std::numeric_limits<float>::infinity(), 0.5f);
    writeImage(m_folder / "v.exr", vectors);
    EXPECT_EQ(readVectors(m_folder / "v.exr"), vectors);
    writeImage(m_folder / "grey.exr", ScalarImage(3, 2, 1));
    writeImage(m_folder / "v.png", ScalarImage(3, 2, 1));
    EXPECT_THROW(readVectors(m_folder / "grey.exr"), Error);
    EXPECT_THROW(readVectors(m_folder / "v.png"), Error);
}

}  // namespace
}  // namespace chiaro
