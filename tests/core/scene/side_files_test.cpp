#include "core/scene/side_files.h"

#include "core/base/atomic_file.h"
#include "tests/support/support.h"

#include <fstream>

namespace chiaro::scene {
namespace {

using Paths = std::vector<std::filesystem::path>;

TEST(SideFiles, AreWhatAnObjAndItsMaterialsName) {
    const test::TemporaryFolder folder;
    writeFileAtomically(folder / "a.obj",
                        "# by hand\nmtllib paint box.mtl\nmtllib gone.mtl\nmtllib ../out.mtl\nv 0 0 0\n");
    writeFileAtomically(folder / "paint box.mtl",
                        "newmtl a\nKd 1 1 1\nmap_Kd -s 1 1 1 textures/oil 1.png\n  map_Bump bump.png\r\n"
                        "map_Ks gone.png\nmap_Kd textures/oil 1.png\n");
    for (const char* file : {"textures/oil 1.png", "bump.png", "other.png"})
        writeFileAtomically(folder / file, "x");
    EXPECT_EQ(sideFiles(folder / "a.obj"), (Paths{"paint box.mtl", "textures/oil 1.png", "bump.png"}));
}

TEST(SideFiles, AreBuffersAndPicturesOfGltf) {
    const test::TemporaryFolder folder;
    const std::string json = R"({"buffers": [{"uri": "mesh%20data.bin"}, {"uri": "data:;base64,AAAA"},
        {"uri": "/etc/passwd"}, {"uri": "../out.bin"}, {"uri": 3}], "images": [{"uri": "t/a.png"}, {}]})";
    writeFileAtomically(folder / "a.gltf", json);
    for (const char* file : {"mesh data.bin", "t/a.png"}) writeFileAtomically(folder / file, "x");
    EXPECT_EQ(sideFiles(folder / "a.gltf"), (Paths{"mesh data.bin", "t/a.png"}));
    // The same in a GLB: header, then the length and the kind of its first part.
    const auto size = std::uint32_t(json.size());
    std::string glb("glTF\2\0\0\0", 8);
    for (const std::uint32_t number : {size + 20, size})
        glb.append(reinterpret_cast<const char*>(&number), sizeof number);
    writeFileAtomically(folder / "a.glb", glb + "JSON" + json);
    EXPECT_EQ(sideFiles(folder / "a.glb"), (Paths{"mesh data.bin", "t/a.png"}));
}

TEST(SideFiles, OfBrokenFilesAreNone) {
    const test::TemporaryFolder folder;
    writeFileAtomically(folder / "a.gltf", "{ \"buffers\": ");
    writeFileAtomically(folder / "b.gltf", "[]");
    writeFileAtomically(folder / "c.glb",
                        std::string("glTF\2\0\0\0\xff\xff\xff\xff\xff\xff\xff\xffJSON{", 21));
    writeFileAtomically(folder / "d.stl", "solid");
    for (const char* file : {"a.gltf", "b.gltf", "c.glb", "d.stl", "none.obj", "none.gltf"})
        EXPECT_TRUE(sideFiles(folder / file).empty()) << file;
}

}  // namespace
}  // namespace chiaro::scene
