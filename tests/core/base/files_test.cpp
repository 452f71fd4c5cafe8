#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "tests/core/base/raw_files.h"
#include "tests/support/support.h"

#include <sys/wait.h>

#include <unistd.h>

namespace chiaro {
namespace {

using namespace test;

TEST(AtomicFile, AppearsWholeOnCommit) {
    const TemporaryFolder folder;
    AtomicFile file(folder / "new/folder/picture.png");
    EXPECT_EQ(file.temporaryPath().extension(), ".png");
    save(file.temporaryPath(), "bytes");
    EXPECT_FALSE(std::filesystem::exists(folder / "new/folder/picture.png"));
    file.commit();
    EXPECT_EQ(load(folder / "new/folder/picture.png"), "bytes");
    EXPECT_EQ(filesIn(folder / "new/folder").size(), 1u);
}

TEST(AtomicFile, LeavesNothingBehindUncommitted) {
    const TemporaryFolder folder;
    save(folder / "a.txt", "old");
    {
        AtomicFile file(folder / "a.txt");
        save(file.temporaryPath(), "new");
    }
    EXPECT_EQ(load(folder / "a.txt"), "old");
    EXPECT_EQ(filesIn(folder.path()).size(), 1u);
}

TEST(AtomicFile, NamesTheDestinationThatRefuses) {
    const TemporaryFolder folder;
    EXPECT_THROW(writeFileAtomically(folder.path(), "x"), Error);
    save(folder / "file", "x");
    EXPECT_THROW(writeFileAtomically(folder / "file/below", "x"), Error);
}

TEST(CheckOutputs, RefusesWhatIsThereAndWhatCannotBeWrittenAndLeavesNoTrace) {
    const TemporaryFolder folder;
    save(folder / "a", "old");
    save(folder / "locked", "old");
    std::filesystem::permissions(folder / "locked", std::filesystem::perms::owner_read);
    EXPECT_THROW(checkOutputs({folder / "b", folder / "a"}, false), Error);
    EXPECT_NO_THROW(checkOutputs({folder / "b", folder / "a"}, true));
    EXPECT_NO_THROW(checkOutputs({folder / "new/folder/b"}, false));
    EXPECT_THROW(checkOutputs({folder / "locked"}, true), Error);
    EXPECT_THROW(checkOutputs({folder.path()}, true), Error);
    EXPECT_THROW(checkOutputs({folder / "a/below/b"}, true), Error);
    EXPECT_THROW(checkOutputs({"/proc/none/b"}, true), Error);
    try {
        checkOutputs({folder / "a"}, false, "add --resume");
        FAIL() << "nothing was said";
    } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).ends_with("/a: is there already; add --resume"))
            << error.what();
    }
    EXPECT_EQ(filesIn(folder.path()).size(), 2u);
    EXPECT_EQ(load(folder / "a"), "old");
}

TEST(RemoveLeftovers, TakesWhatNobodyWritesAnyMore) {
    const TemporaryFolder folder;
    const pid_t ended = fork();
    if (ended == 0) _exit(0);
    waitpid(ended, nullptr, 0);
    const std::string here = "-3-" + thisMachine();
    const std::string dead = std::to_string(ended), alive = std::to_string(getpid());
    for (const std::string& name : {".a.0001." + dead + here + ".png", ".a.0001." + alive + here + ".png",
                                    ".a.0002." + dead + here + ".png", ".a.0001." + dead + here + ".exr",
                                    ".a.0001." + dead + "-3-elsewhere.png"})
        save(folder / name, "half");
    removeLeftovers({folder / "a.0001.png", folder / "none/a.0001.png"});
    EXPECT_FALSE(std::filesystem::exists(folder / (".a.0001." + dead + here + ".png")));
    EXPECT_EQ(filesIn(folder.path()).size(), 4u);
}

TEST(ReadFile, ReadsUpToItsLimit) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string_view("a\0b", 3));
    EXPECT_EQ(readFile(folder / "a", 3), std::string("a\0b", 3));
    EXPECT_THROW(readFile(folder / "a", 2), Error);
    EXPECT_THROW(readFile(folder / "absent", 2), Error);
    EXPECT_THROW(readFile(folder.path(), 2), Error);
}

}  // namespace
}  // namespace chiaro
