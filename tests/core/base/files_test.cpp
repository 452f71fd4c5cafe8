#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "tests/core/base/raw_files.h"
#include "tests/support/support.h"

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
