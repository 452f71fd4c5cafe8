// Everything that is written, on disks of every fullness: a whole file, or one sentence and the old file as
// it was.

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/image_io.h"
#include "core/base/random.h"
#include "core/export/textured_mesh.h"
#include "core/export/video.h"
#include "core/export/video_container.h"
#include "core/project/project.h"
#include "core/project/texture_cache.h"
#include "tests/core/scene/shapes.h"
#include "tests/support/small_disk.h"

#include <spdlog/fmt/fmt.h>

namespace chiaro {
namespace {

namespace fs = std::filesystem;

test::SmallDisk* disk = nullptr;  // as long as the program

/// No two pixels alike, so that no format makes it smaller.
ColorImage noise(int side) {
    ColorImage image(side, side);
    Random random(std::uint64_t(side), 0);
    for (glm::vec3& pixel : image.pixels())
        pixel = {float(random.uniform()), float(random.uniform()), float(random.uniform())};
    return image;
}

exporting::TexturedScene paintedBall(int side, bool hasColors) {
    const scene::Mesh mesh = test::ball(side / 2, side / 4);
    exporting::TexturedObject object{"ball", glm::mat4(1), mesh.positions, mesh.normals,
                                     {},     {},           mesh.triangles};
    exporting::TexturedScene scene;
    for (const glm::vec3& position : mesh.positions)
        if (hasColors)
            object.colors.emplace_back(glm::u8vec3(100.0f + 50.0f * position));
        else
            object.coordinates.push_back(0.5f + 0.4f * glm::vec2(position));
    scene.objects.push_back(std::move(object));
    if (hasColors) return scene;
    scene.texture = exporting::ByteImage(side, side);
    Random random(1, 0);
    for (glm::u8vec3& texel : scene.texture.pixels()) texel = glm::u8vec3(std::uint8_t(random.below(256)));
    return scene;
}

project::Project projectOf(int side) {
    project::Project project;
    for (int i = 0; i < side; ++i)
        project.samples.push_back({.name = fmt::format("paint number {}", i),
                                   .scan = *disk / fmt::format("scan {}.png", i),
                                   .strip = {},
                                   .gradient = {},
                                   .recoloring = {}});
    return project;
}

void writeVideo(const fs::path& path, int side) {
    exporting::VideoWriter video(path, side, side, 24);
    for (int frame = 0; frame < 6; ++frame) {
        ColorImage picture = noise(side);
        for (glm::vec3& pixel : picture.pixels()) pixel *= 0.2f * float(frame);
        video.add(picture);
    }
    video.finish();
}

/// A way to write a file; `side` says how large.
struct Kind {
    const char* name;  ///< of the file
    void (*write)(const fs::path& path, int side);
    std::array<int, 2> sides;
};

const std::vector<Kind> kinds{
    {"a.chiaro",
     [](const fs::path& path, int side) { project::writeProject(path, projectOf(side)); },
     {4, 200}},
    {"a.png", [](const fs::path& path, int side) { writeImage(path, noise(side)); }, {40, 200}},
    {"a.exr", [](const fs::path& path, int side) { writeImage(path, noise(side)); }, {40, 200}},
    {"a.tif", [](const fs::path& path, int side) { writeImage(path, noise(side)); }, {40, 200}},
    {"a.jpg", [](const fs::path& path, int side) { writeImage(path, noise(side)); }, {40, 200}},
    {"a.glb",
     [](const fs::path& path, int side) { exporting::writeTexturedScene(path, paintedBall(side, false)); },
     {40, 160}},
    {"a.obj",
     [](const fs::path& path, int side) { exporting::writeTexturedScene(path, paintedBall(side, false)); },
     {40, 160}},
    {"a.ply",
     [](const fs::path& path, int side) { exporting::writeTexturedScene(path, paintedBall(side, true)); },
     {40, 160}},
    {"a.mp4", writeVideo, {64, 160}},
    {"a.webm", writeVideo, {64, 160}},
    {"a.mkv", writeVideo, {64, 160}}};

using Files = std::map<std::string, std::string>;

Files filesOnDisk() {
    Files files;
    for (const fs::path& file : test::filesIn(disk->path()))
        files[file.filename().string()] = readFile(file, 1 << 28);
    return files;
}

/// Videos of the same frames were seen to differ in length: MP4 by 1.4 % on a busy machine, why is not known;
/// Matroska holds numbers drawn for each. So a video is whole when its container is, with about as many
/// bytes; VideoWriter has counted its frames.
bool isAsWhole(const std::string& name, const std::string& content, const std::string& whole) {
    if (!exporting::isWritableVideo(name)) return content == whole;
    const double ratio = double(content.size()) / double(whole.size());
    return ratio > 0.8 && ratio < 1.25 && exporting::isWholeContainer(*disk / name);
}

bool areAsWhole(const Files& files, const Files& whole) {
    return std::ranges::equal(files, whole, [](const auto& one, const auto& other) {
        return one.first == other.first && isAsWhole(one.first, one.second, other.second);
    });
}

std::uint64_t bytesOf(const Files& files) {
    std::uint64_t bytes = 0;
    for (const auto& [name, content] : files) bytes += content.size();
    return bytes;
}

void clearDisk() {
    disk->leaveAll();
    for (const fs::path& file : test::filesIn(disk->path())) fs::remove(file);
}

class FullDisk : public testing::TestWithParam<Kind> {
protected:
    void TearDown() override { clearDisk(); }
};

/// Twelve shares of the space that the files take, from none to more than enough.
constexpr std::array shares{0.0, 0.05, 0.2, 0.4, 0.5, 0.6, 0.75, 0.9, 0.97, 1.0, 1.1, 2.5};

TEST_P(FullDisk, HoldsAWholeFileOrTheOldOne) {
    const Kind& kind = GetParam();
    const fs::path path = *disk / kind.name;
    int failed = 0, written = 0;
    for (const int side : kind.sides) {
        clearDisk();
        kind.write(path, side);
        const Files whole = filesOnDisk();
        for (const double share : shares) {
            clearDisk();
            for (const auto& [name, content] : whole) writeFileAtomically(*disk / name, "the old " + name);
            const Files old = filesOnDisk();
            disk->leave(std::uint64_t(share * double(bytesOf(whole))));
            std::string sentence;
            try {
                kind.write(path, side);
            } catch (const Error& error) {
                sentence = error.what();
            }
            disk->leaveAll();
            SCOPED_TRACE(fmt::format("{} of {}, {} of {} bytes left, said: {}", kind.name, side, share,
                                     bytesOf(whole), sentence));
            if (sentence.empty()) {
                EXPECT_TRUE(areAsWhole(filesOnDisk(), whole))
                    << "not whole, but " << bytesOf(filesOnDisk()) << " bytes";
                ++written;
            } else {
                EXPECT_NE(sentence.find(kind.name[0]), std::string::npos);
                EXPECT_NE(sentence.find(disk->path().string()), std::string::npos);
                EXPECT_TRUE(filesOnDisk() == old) << "the old files are not as they were";
                ++failed;
            }
        }
    }
    EXPECT_GT(failed, 2);
    EXPECT_GT(written, 1);
}

INSTANTIATE_TEST_SUITE_P(Every, FullDisk, testing::ValuesIn(kinds),
                         [](const auto& kind) { return std::string(kind.param.name + 2); });

methods::ViewTextures texturesOf(int side) {
    methods::ViewTextures textures;
    textures.views.resize(1);
    Random random(7, 0);
    Image<methods::PackedTexel> texels(side, side);
    for (auto& texel : texels.pixels()) texel = methods::PackedTexel(short(random.below(9999)));
    textures.views[0].levels.push_back(texels);
    return textures;
}

TEST(FullDiskOfTheCache, HoldsWholeTexturesOrNone) {
    for (const int side : {16, 200})
        for (const double share : shares) {
            clearDisk();
            const project::TextureCache cache(disk->path());
            cache.store(1, texturesOf(20));
            const Files before = filesOnDisk();
            disk->leave(std::uint64_t(share * double(side * side) * sizeof(methods::PackedTexel)));
            EXPECT_NO_THROW(cache.store(2, texturesOf(side)));
            disk->leaveAll();
            SCOPED_TRACE(fmt::format("{} of {}", share, side));
            ASSERT_TRUE(cache.find(1));
            if (const auto found = cache.find(2))
                EXPECT_EQ(found->views[0].levels, texturesOf(side).views[0].levels);
            else
                EXPECT_TRUE(filesOnDisk() == before) << "something was left behind";
        }
    clearDisk();
}

}  // namespace
}  // namespace chiaro

int main(int argc, char** argv) {
    chiaro::test::SmallDisk disk;
    chiaro::disk = &disk;
    std::fputs(disk.isOwn() ? "on a file system in memory\n" : "with a limit on the size of files\n", stderr);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
