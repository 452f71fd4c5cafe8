#include "core/project/backups.h"

#include "core/base/atomic_file.h"
#include "core/base/random.h"
#include "core/project/project.h"
#include "tests/support/support.h"

#include <spdlog/fmt/fmt.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <unistd.h>

namespace chiaro::project {
namespace {

std::string textOf(const std::filesystem::path& path) {
    return readFile(path, 1 << 20);
}

TEST(Backups, TheLatestFiveAreKept) {
    const test::TemporaryFolder folder;
    const auto file = folder / "a.chiaro";
    keepBackup(file);  // there is nothing yet
    EXPECT_TRUE(backupsOf(file).empty());
    for (int version = 1; version <= 8; ++version) {
        keepBackup(file);
        writeFileAtomically(file, std::to_string(version));
    }
    EXPECT_EQ(textOf(file), "8");
    const auto backups = backupsOf(file);
    ASSERT_EQ(backups.size(), 5u);
    for (std::size_t i = 0; i < backups.size(); ++i) EXPECT_EQ(textOf(backups[i]), std::to_string(7 - i));
    EXPECT_EQ(backups[0].filename(), "a.chiaro1");
}

TEST(Backups, SavingTheSameAgainPushesNoneOut) {
    const test::TemporaryFolder folder;
    const auto file = folder / "a.chiaro";
    writeFileAtomically(file, "one");
    for (int i = 0; i < 4; ++i) keepBackup(file);
    EXPECT_EQ(backupsOf(file).size(), 1u);
}

TEST(Backups, AFolderThatRefusesThemIsNoObstacle) {
    EXPECT_NO_THROW(keepBackup("/proc/version"));
    EXPECT_NO_THROW(removeLeftovers("/nowhere/a.chiaro"));
}

TEST(Backups, OnlyLeftoversOfTheDeadAreRemoved) {
    const test::TemporaryFolder folder;
    const auto file = folder / "a.chiaro";
    const pid_t dead = ::fork();
    if (dead == 0) ::_exit(0);
    ::waitpid(dead, nullptr, 0);
    const auto temporary = [&](const std::string& stem, int process) {
        const auto path = folder / fmt::format(".{}.{}-3-{}.chiaro", stem, process, thisMachine());
        writeFileAtomically(path, "x");
        return path;
    };
    const auto mine = temporary("a", ::getpid()), others = temporary("b", dead), left = temporary("a", dead);
    removeLeftovers(file);
    EXPECT_TRUE(std::filesystem::exists(mine));
    EXPECT_TRUE(std::filesystem::exists(others));
    EXPECT_FALSE(std::filesystem::exists(left));
}

/// Folders are shared between machines: a number that names no process here may name one elsewhere.
TEST(Backups, LeftoversOfOtherMachinesAreRemovedOnlyWhenTheyAreOld) {
    const test::TemporaryFolder folder;
    const auto file = folder / "a.chiaro";
    const pid_t dead = ::fork();
    if (dead == 0) ::_exit(0);
    ::waitpid(dead, nullptr, 0);
    const auto written = [&](const std::string& name, std::chrono::hours age) {
        writeFileAtomically(folder / name, "x");
        std::filesystem::last_write_time(folder / name, std::filesystem::file_time_type::clock::now() - age);
        return folder / name;
    };
    using std::chrono::hours;
    const auto fresh = written(fmt::format(".a.{}-3-elsewhere.chiaro", dead), hours(1));
    const auto old = written(fmt::format(".a.{}-4-elsewhere.chiaro", dead), hours(30));
    const auto nameless = written(fmt::format(".a.{}-5.chiaro", dead), hours(1));
    removeLeftovers(file);
    EXPECT_TRUE(std::filesystem::exists(fresh));
    EXPECT_FALSE(std::filesystem::exists(old));
    EXPECT_TRUE(std::filesystem::exists(nameless)) << "of whichever machine";
}

Project projectNamed(const std::string& name) {
    Project project;
    for (int i = 0; i < 60; ++i)
        project.samples.push_back(
            {.name = name, .scan = "/scans/oil.png", .strip = {}, .gradient = {}, .recoloring = {}});
    return project;
}

/// Saves over and over as the studio does, until it is killed.
[[noreturn]] void saveForever(const std::filesystem::path& file) {
    const Project one = projectNamed("one"), two = projectNamed("two");
    for (;;)
        for (const Project* project : {&one, &two}) {
            removeLeftovers(file);
            keepBackup(file);
            writeProject(file, *project);
        }
}

/// Long: 200 times, with CHIARO_LONG_TESTS=1 in the environment.
TEST(Backups, NoProjectIsLostWhenTheProgramIsKilledAmidSaving) {
    const test::TemporaryFolder folder;
    const auto file = folder / "a.chiaro";
    writeProject(file, projectNamed("one"));
    Random random(1);
    const int kills = std::getenv("CHIARO_LONG_TESTS") ? 200 : 25;
    for (int kill = 0; kill < kills; ++kill) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) saveForever(file);
        ::usleep(unsigned(1000 + random.uniform() * 40'000));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const Project found = readProject(file);
        ASSERT_EQ(found.samples.size(), 60u);
        for (const auto& backup : backupsOf(file))
            ASSERT_EQ(readProject(backup).samples.size(), 60u) << backup;
    }
    removeLeftovers(file);
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++files;
    EXPECT_LE(files, 7u) << "the project, five backups, and one that was about to be";
}

}  // namespace
}  // namespace chiaro::project
