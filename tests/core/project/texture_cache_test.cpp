#include "core/project/texture_cache.h"

#include "core/base/atomic_file.h"
#include "core/base/random.h"
#include "tests/support/support.h"

#include <spdlog/fmt/fmt.h>

namespace chiaro::project {
namespace {

methods::ViewTextures someTextures(int seed) {
    methods::ViewTextures textures;
    textures.report = {7, 0.25};
    Random random{std::uint64_t(seed)};
    textures.views.resize(3);  // the middle one stays empty
    for (const std::size_t view : {0u, 2u}) {
        textures.views[view].origin = {int(view), -4};
        for (int level = 0; level < 2; ++level) {
            Image<methods::PackedTexel> texels(5, 3);
            for (auto& texel : texels.pixels()) texel = methods::PackedTexel(short(random.below(9999)));
            textures.views[view].levels.push_back(texels);
        }
    }
    return textures;
}

void expectEqual(const methods::ViewTextures& a, const methods::ViewTextures& b) {
    ASSERT_EQ(a.views.size(), b.views.size());
    EXPECT_EQ(a.report.blocks, b.report.blocks);
    EXPECT_EQ(a.report.overlapError, b.report.overlapError);
    for (std::size_t i = 0; i < a.views.size(); ++i) {
        EXPECT_EQ(a.views[i].origin, b.views[i].origin);
        EXPECT_EQ(a.views[i].levels, b.views[i].levels);
    }
}

TEST(TextureCache, FindsWhatWasStored) {
    const test::TemporaryFolder folder;
    const TextureCache cache(folder / "not/yet/there");
    EXPECT_FALSE(cache.find(5));
    cache.store(5, someTextures(1));
    cache.store(6, someTextures(2));
    ASSERT_TRUE(cache.find(5));
    expectEqual(*cache.find(5), someTextures(1));
    expectEqual(*cache.find(6), someTextures(2));
    EXPECT_FALSE(cache.find(7));
}

TEST(TextureCache, NeverTrustsADamagedFile) {
    const test::TemporaryFolder folder;
    const TextureCache cache(folder.path());
    cache.store(5, someTextures(1));
    const std::filesystem::path file = test::filesIn(folder.path()).front();
    const std::string whole = readFile(file, 1 << 20);
    std::vector<std::string> damaged{"", whole.substr(0, 10), whole.substr(0, whole.size() - 1), whole + "x"};
    for (std::size_t at = 0; at < whole.size(); at += 7) {
        damaged.push_back(whole);
        damaged.back()[at] = char(~damaged.back()[at]);
    }
    for (const std::string& bytes : damaged) {
        writeFileAtomically(file, bytes);
        EXPECT_FALSE(cache.find(5));
        EXPECT_FALSE(std::filesystem::exists(file));
    }
    // Another key's file under this name.
    writeFileAtomically(folder / "0000000000000006.views", whole);
    EXPECT_FALSE(cache.find(6));
}

TEST(TextureCache, StaysWithinItsBoundAndDropsWhatWasNotUsedForLongest) {
    const test::TemporaryFolder folder;
    TextureCache(folder.path()).store(1, someTextures(1));
    const auto bytes = std::filesystem::file_size(test::filesIn(folder.path()).front());
    const TextureCache cache(folder.path(), 3 * bytes);
    const auto age = [&](int key, int hours) {
        std::filesystem::last_write_time(
            folder / fmt::format("{:016x}.views", key),
            std::filesystem::file_time_type::clock::now() - std::chrono::hours(hours));
    };
    age(1, 5);
    cache.store(2, someTextures(2));
    age(2, 9);
    cache.store(3, someTextures(3));
    age(3, 1);
    ASSERT_TRUE(cache.find(1));  // used: now the youngest
    cache.store(4, someTextures(4));
    EXPECT_FALSE(cache.find(2));
    EXPECT_TRUE(cache.find(1));
    EXPECT_TRUE(cache.find(3));
    EXPECT_TRUE(cache.find(4));
}

TEST(TextureCache, AnUnwritableFolderIsNoError) {
    const test::TemporaryFolder folder;
    writeFileAtomically(folder / "file", "x");
    const TextureCache cache(folder / "file");
    cache.store(1, someTextures(1));
    EXPECT_FALSE(cache.find(1));
    const TextureCache none{std::filesystem::path()};
    none.store(1, someTextures(1));
    EXPECT_FALSE(none.find(1));
}

}  // namespace
}  // namespace chiaro::project
