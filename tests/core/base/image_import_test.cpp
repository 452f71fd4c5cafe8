#include "core/base/image_import.h"
#include "core/base/stored_image.h"

#include "core/base/error.h"
#include "tests/core/base/raw_files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

namespace chiaro {
namespace {

using namespace test;

void expectSame(const DecodedImage& a, const DecodedImage& b, const std::filesystem::path& path) {
    EXPECT_EQ(std::tuple(a.width, a.height, a.channels, a.linear, a.bits),
              std::tuple(b.width, b.height, b.channels, b.linear, b.bits))
        << path;
    EXPECT_TRUE(a.values == b.values) << path;
}

std::string refusalOf(const std::function<void()>& read) {
    try {
        read();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

std::vector<std::filesystem::path> pictures() {
    std::vector<std::filesystem::path> files = filesIn(resource("demo"));
    if (haveSharedData())
        for (const char* folder : {"samples", "samples/ünï codé", "broken/images"})
            for (const auto& path : filesIn(sharedData() / folder)) files.push_back(path);
    std::erase_if(files, [](const auto& path) { return std::filesystem::file_size(path) > 3'000'000; });
    return files;
}

/// The same picture or the same sentence, wherever a file is read.
TEST(ImageImport, GivesWhatReadingHereGives) {
    helper::HelperPool pool({});
    for (const auto& path : pictures()) {
        DecodedImage here, there;
        const std::string refusedHere = refusalOf([&] { here = readImage(path); });
        const std::string refusedThere = refusalOf([&] { there = importImage(pool, path, {}, {}); });
        expectSame(here, there, path);
        EXPECT_EQ(refusedHere.substr(0, refusedHere.find(" can't be decoded")),
                  refusedThere.substr(0, refusedThere.find(" can't be decoded")))
            << path;
    }
}

TEST(ImageImport, GivesTheMetadata) {
    const TemporaryFolder folder;
    writeImage(folder / "made.png", ColorImage(4, 4), {{"chiaro:command", "render"}, {"Software", "Chiaro"}});
    helper::HelperPool pool({});
    EXPECT_EQ(importImageMetadata(pool, folder / "made.png", {}), readImageMetadata(folder / "made.png"));
}

TEST(ImageImport, ErrorsNameTheFileAsItWasGiven) {
    const TemporaryFolder folder;
    save(folder / "broken.png", png(4, 4, 8, PngColor::Grey, {"abc"}));
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    helper::HelperPool pool({});
    EXPECT_TRUE(
        refusalOf([&] { importImage(pool, "broken.png", {}, {}); }).starts_with("broken.png: the PNG file"));
    std::filesystem::current_path(before);
}

/// Whatever byte of its answer a helper changes: a picture that is one, or a sentence.
TEST(ImageImport, TrustsNoAnswer) {
    const TemporaryFolder folder;
    helper::HelperPool pool({.program = CHIARO_HOSTILE_HELPER});
    int refused = 0;
    for (std::size_t place = 0; place < sizeof(StoredImage); ++place) {
        const auto path = folder / ("lie-" + std::to_string(place) + ".png");
        save(path, png(4, 2, 8, PngColor::Grey, {"abcd", "efgh"}));
        const std::string refusal = refusalOf([&] {
            const DecodedImage image = importImage(pool, path, {}, {});
            EXPECT_EQ(image.values.size(),
                      std::size_t(image.width) * std::size_t(image.height) * std::size_t(image.channels));
        });
        if (!refusal.empty()) {
            ++refused;
            EXPECT_TRUE(refusal.starts_with(path.string() + ": ")) << refusal;
        }
    }
    EXPECT_GE(refused, 20);
}

}  // namespace
}  // namespace chiaro
