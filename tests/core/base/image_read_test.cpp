#include "core/base/error.h"
#include "core/base/image_io.h"
#include "tests/core/base/raw_files.h"
#include "tests/support/support.h"

#include <chrono>
#include <limits>

namespace chiaro {
namespace {

using namespace test;

class ImageRead : public testing::Test {
protected:
    DecodedImage read(const Bytes& bytes, const ImageLimits& limits = {}) {
        save(m_file, bytes);
        return readImage(m_file, limits);
    }
    /// The sentence that the bytes are refused with; fails when they are read.
    std::string refusal(const Bytes& bytes) {
        try {
            read(bytes);
        } catch (const Error& error) {
            const std::string text = error.what();
            EXPECT_TRUE(text.starts_with(m_file.string() + ": ")) << text;
            EXPECT_NE(text.find("; "), std::string::npos) << text;
            return text.substr(m_file.string().size() + 2);
        }
        ADD_FAILURE() << "was read";
        return {};
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "picture ünï.bin";
};

std::vector<float> unit(std::initializer_list<int> bytes) {
    std::vector<float> values;
    for (const int byte : bytes) values.push_back(float(byte) / 255.0f);
    return values;
}

TEST_F(ImageRead, ReadsGreyPng) {
    const DecodedImage image = read(png(3, 1, 8, PngColor::Grey, {{"\x00\x80\xff", 3}}));
    EXPECT_EQ(image.width, 3);
    EXPECT_EQ(image.height, 1);
    EXPECT_EQ(image.channels, 1);
    EXPECT_FALSE(image.linear);
    EXPECT_EQ(image.values, unit({0, 128, 255}));
}

TEST_F(ImageRead, ReadsBlackAndWhitePng) {
    EXPECT_EQ(read(png(3, 1, 1, PngColor::Grey, {"\xA0"})).values, unit({255, 0, 255}));
}

TEST_F(ImageRead, ReadsSixteenBitPng) {
    const DecodedImage image = read(png(2, 1, 16, PngColor::Grey, {{"\x00\x01\xff\xff", 4}}));
    EXPECT_EQ(image.values, (std::vector<float>{1.0f / 65535.0f, 1.0f}));
}

TEST_F(ImageRead, ReadsGreyAndAlphaUnpremultiplied) {
    const DecodedImage image = read(png(1, 1, 8, PngColor::GreyAlpha, {"\xC8\x33"}));
    EXPECT_EQ(image.channels, 2);
    EXPECT_EQ(image.values, unit({200, 51}));
}

TEST_F(ImageRead, PaletteBecomesRgbAndItsTransparencyAlpha) {
    const Bytes palette = pngChunk("PLTE", {"\x0a\x14\x1e\x28\x32\x3c", 6});
    const DecodedImage opaque = read(png(2, 1, 8, PngColor::Palette, {{"\x01\x00", 2}}, palette));
    EXPECT_EQ(opaque.channels, 3);
    EXPECT_EQ(opaque.values, unit({40, 50, 60, 10, 20, 30}));
    const Bytes coverage = pngChunk("tRNS", {"\x80\xff", 2});
    const DecodedImage seeThrough =
        read(png(2, 1, 8, PngColor::Palette, {{"\x01\x00", 2}}, palette + coverage));
    EXPECT_EQ(seeThrough.channels, 4);
    EXPECT_EQ(seeThrough.values, unit({40, 50, 60, 255, 10, 20, 30, 128}));
}

TEST_F(ImageRead, CmykTiffBecomesRgb) {
    const DecodedImage image = read(tiff({2, 1, 4, 5, 1, {"\x00\x00\x00\x00\xff\x00\x00\x80", 8}}));
    EXPECT_EQ(image.channels, 3);
    ASSERT_EQ(image.values.size(), 6u);
    const std::vector<float> expected = unit({255, 255, 255, 0, 127, 127});
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(image.values[i], expected[i], 1.01 / 255) << i;
}

/// A 3 x 2 picture whose upright form is 1 2 3 / 4 5 6, stored in each of the eight ways (EXIF 2.3, 4.6.4).
TEST_F(ImageRead, HonoursEveryOrientation) {
    const struct {
        std::uint32_t orientation, width, height;
        Bytes stored;
    } cases[] = {{1, 3, 2, "\1\2\3\4\5\6"}, {2, 3, 2, "\3\2\1\6\5\4"}, {3, 3, 2, "\6\5\4\3\2\1"},
                 {4, 3, 2, "\4\5\6\1\2\3"}, {5, 2, 3, "\1\4\2\5\3\6"}, {6, 2, 3, "\3\6\2\5\1\4"},
                 {7, 2, 3, "\6\3\5\2\4\1"}, {8, 2, 3, "\4\1\5\2\6\3"}};
    for (const auto& [orientation, width, height, stored] : cases) {
        const DecodedImage image = read(tiff({width, height, 1, 1, orientation, stored}));
        EXPECT_EQ(image.width, 3) << orientation;
        EXPECT_EQ(image.height, 2) << orientation;
        EXPECT_EQ(image.values, unit({1, 2, 3, 4, 5, 6})) << orientation;
    }
}

TEST_F(ImageRead, RefusesWhatIsNoPicture) {
    EXPECT_THROW(readImage(m_folder / "absent.png"), Error);
    EXPECT_THROW(readImage(m_folder.path()), Error);
    EXPECT_EQ(refusal(""), "the file is empty; save or copy the picture again");
    EXPECT_EQ(refusal("GIF89a..........").find("is not a picture that can be read"), 0u);
}

TEST_F(ImageRead, RefusesHugeHeadersBeforeDecoding) {
    const auto start = std::chrono::steady_clock::now();
    const std::string sentence = refusal(png(100'000, 100'000, 8, PngColor::Rgb, {Bytes(64, 'x')}));
    EXPECT_EQ(sentence.find("is 100000 x 100000 pixels; pictures may be up to"), 0u) << sentence;
    refusal(tiff({100'000, 100'000, 1, 1, 1, Bytes(64, 'x')}));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

TEST_F(ImageRead, HonoursTheLimitsGiven) {
    const Bytes file = png(4, 2, 8, PngColor::Grey, {"abcd", "efgh"});
    EXPECT_EQ(read(file, {4, 8}).width, 4);
    EXPECT_THROW(read(file, {3, 8}), Error);
    EXPECT_THROW(read(file, {4, 7}), Error);
}

TEST_F(ImageRead, RefusesDamagedPng) {
    Bytes file = png(8, 2, 8, PngColor::Grey, {"abcdefgh", "ijklmnop"});
    file[20] = char(file[20] ^ 1);  // the header no longer matches its check sum
    EXPECT_EQ(refusal(file).find("the PNG file can't be decoded"), 0u);
}

TEST_F(ImageRead, KeepsLibraryNoiseOffStandardError) {
    testing::internal::CaptureStderr();
    refusal(png(8, 2, 8, PngColor::Grey, {"short"}));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

/// The whole picture or an error, wherever the file is cut off.
TEST_F(ImageRead, NeverGivesHalfAPicture) {
    ColorImage image(40, 30);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) image(x, y) = glm::vec3(x * 7 % 40, y * 11 % 30, x * y % 37) / 40.0f;
    for (const char* extension : {".png", ".tif", ".jpg", ".exr"}) {
        const std::filesystem::path whole = m_folder / (std::string("whole") + extension);
        writeImage(whole, image);
        const DecodedImage expected = readImage(whole);
        const Bytes bytes = load(whole);
        std::size_t refused = 0;
        const std::size_t step = bytes.size() / 60 + 1;
        for (std::size_t length = 0; length < bytes.size(); length += step) {
            save(m_file, bytes.substr(0, length));
            try {
                EXPECT_EQ(readImage(m_file).values, expected.values) << extension << " cut at " << length;
            } catch (const Error&) {
                ++refused;
            }
        }
        EXPECT_GE(refused, 40u) << extension;
    }
}

TEST_F(ImageRead, RefusesValuesThatAreNotFinite) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        ScalarImage image(4, 4, 0.5f);
        image(2, 3) = bad;
        writeImage(m_folder / "bad.exr", image);
        try {
            readImage(m_folder / "bad.exr");
            ADD_FAILURE() << bad << " was read";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("not finite"), std::string::npos) << error.what();
        }
    }
}

TEST_F(ImageRead, TakesValuesThatAreNotFiniteWhereTheyMayBe) {
    ScalarImage image(4, 4, 0.5f);
    image(2, 3) = std::numeric_limits<float>::quiet_NaN();
    writeImage(m_folder / "light.exr", image);
    const DecodedImage read = readImage(m_folder / "light.exr", {.mayBeNotFinite = true});
    EXPECT_TRUE(std::isnan(read.values[14]));
    EXPECT_EQ(read.values[13], 0.5f);
}

TEST_F(ImageRead, TellsHowManyBitsWereStored) {
    EXPECT_EQ(read(png(4, 1, 8, PngColor::Grey, {"abcd"})).bits, 8);
    EXPECT_EQ(read(png(2, 1, 16, PngColor::Grey, {"abcd"})).bits, 16);
    writeImage(m_folder / "float.exr", ScalarImage(4, 4, 0.5f));
    EXPECT_EQ(readImage(m_folder / "float.exr").bits, 0);
}

/// Real damaged files: each is read or refused with a sentence, quickly.
TEST_F(ImageRead, SurvivesBrokenFiles) {
    CHIARO_NEEDS_SHARED_DATA();
    for (const auto& path : filesIn(sharedData() / "broken" / "images")) {
        const auto start = std::chrono::steady_clock::now();
        try {
            const DecodedImage image = readImage(path);
            EXPECT_EQ(image.values.size(), std::size_t(image.width * image.height * image.channels)) << path;
        } catch (const Error& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with(path.string() + ": ")) << error.what();
        }
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2)) << path;
    }
}

TEST_F(ImageRead, AdobeCmykJpegIsNotInverted) {
    CHIARO_NEEDS_SHARED_DATA();
    const DecodedImage image = readImage(sharedData() / "broken" / "images" / "pil_sample_cmyk.jpg");
    EXPECT_EQ(image.channels, 3);
    EXPECT_NEAR(image.values[0], 1.0, 2.0 / 255);
    EXPECT_NEAR(image.values[1], 13.0 / 255, 2.0 / 255);
    EXPECT_NEAR(image.values[2], 25.0 / 255, 2.0 / 255);
}

}  // namespace
}  // namespace chiaro
