#include "core/base/helper/helper_pool.h"

#include "core/base/error.h"
#include "core/base/helper/plain_bytes.h"
#include "tests/support/support.h"

#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <future>
#include <thread>

namespace chiaro::helper {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

ImportSettings hostile(int seconds = 20, int megabytes = 4096) {
    return {.megabytes = megabytes, .seconds = seconds, .program = CHIARO_HOSTILE_HELPER};
}

std::string request(const std::string& handler, const std::string& text = {}) {
    PlainWriter writer;
    writer.addText(handler);
    writer.addText(text);
    return writer.take();
}

const std::filesystem::path file = "folder/strip.png";

/// The sentence that asking ends with.
std::string refusal(HelperPool& pool, const std::string& handler) {
    try {
        pool.ask(request(handler), file, {});
    } catch (const Error& error) {
        return error.what();
    }
    return "was answered";
}

bool endsSoon(pid_t process) {
    for (int i = 0; i < 200; ++i) {
        if (::kill(process, 0) != 0) return true;
        std::this_thread::sleep_for(10ms);
    }
    return false;
}

/// Whether a child of this process has ended without being waited for.
bool hasZombies() {
    siginfo_t info{};
    return ::waitid(P_ALL, 0, &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid != 0;
}

TEST(HelperPool, KeepsAHelperWarm) {
    HelperPool pool(hostile());
    EXPECT_EQ(pool.ask(request("wait", "first"), file, {}).bytes, "first");
    const std::vector<int> before = pool.idleProcesses();
    EXPECT_EQ(pool.ask(request("wait", "second"), file, {}).bytes, "second");
    EXPECT_EQ(pool.idleProcesses(), before);
    EXPECT_EQ(before.size(), 1u);
}

TEST(HelperPool, ACrashIsOneSentenceAndTheNextFileIsRead) {
    HelperPool pool(hostile());
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(refusal(pool, "crash"),
                  "folder/strip.png: can't be read: its reader crashed (Segmentation fault); the file may be "
                  "damaged, so copy it or save it again");
    EXPECT_EQ(pool.ask(request("wait", "still here"), file, {}).bytes, "still here");
}

TEST(HelperPool, AHangEndsAtTheLimit) {
    HelperPool pool(hostile(1));
    const auto start = Clock::now();
    EXPECT_EQ(
        refusal(pool, "hang"),
        "folder/strip.png: was not read within 1 seconds; it may be damaged; raise CHIARO_IMPORT_SECONDS "
        "if it is sound and just large");
    EXPECT_GE(Clock::now() - start, 1s);
    EXPECT_LT(Clock::now() - start, 3s);
}

TEST(HelperPool, MemoryIsLimited) {
    HelperPool pool(hostile(20, 512));
    EXPECT_EQ(
        refusal(pool, "eat memory"),
        "folder/strip.png: takes more memory to read than a file may (512 MB); make it smaller, or raise "
        "CHIARO_IMPORT_MEMORY if it is sound");
}

TEST(HelperPool, CancellingNeedsNoPatience) {
    HelperPool pool(hostile());
    pool.ask(request("wait"), file, {});
    const int helper = pool.idleProcesses().front();
    std::stop_source stop;
    auto asked = std::async([&] {
        EXPECT_THROW(pool.ask(request("hang"), file, Task(stop.get_token())), Cancelled);
        return Clock::now();
    });
    std::this_thread::sleep_for(100ms);
    const auto start = Clock::now();
    stop.request_stop();
    EXPECT_LT(asked.get() - start, 200ms);
    EXPECT_TRUE(endsSoon(helper));
}

TEST(HelperPool, AStopOfTheProgramCancelsEveryImport) {
    std::stop_source stop;
    HelperPool pool(hostile(), stop.get_token());
    stop.request_stop();
    EXPECT_THROW(pool.ask(request("hang"), file, {}), Cancelled);
}

TEST(HelperPool, TheHelperCanNeitherWriteNorConnectNorStartAnything) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "old") << "kept";
    HelperPool pool(hostile());
    EXPECT_EQ(pool.ask(request("break out", folder.path().string()), file, {}).bytes, "");
    EXPECT_EQ(test::filesIn(folder.path()).size(), 1u);
    EXPECT_EQ(std::filesystem::file_size(folder / "old"), 4u);
}

TEST(HelperPool, MemoryThatCouldStillChangeIsRefused) {
    HelperPool pool(hostile());
    EXPECT_EQ(
        refusal(pool, "open memory"),
        "folder/strip.png: can't be read: its reader gave an answer without sense; the file may be damaged, "
        "so copy it or save it again");
}

TEST(HelperPool, SeveralAtOnce) {
    HelperPool pool(hostile());
    std::vector<std::future<std::string>> answers;
    for (int i = 0; i < 8; ++i)
        answers.push_back(std::async(std::launch::async, [&pool, i] {
            return pool.ask(request("wait", std::to_string(i)), file, {}).bytes;
        }));
    for (int i = 0; i < 8; ++i) EXPECT_EQ(answers[std::size_t(i)].get(), std::to_string(i));
    EXPECT_LE(pool.idleProcesses().size(), 4u);
    EXPECT_GE(pool.idleProcesses().size(), 2u);
}

TEST(HelperPool, TellsProgress) {
    HelperPool pool(hostile());
    double last = 0;
    pool.ask(request("wait"), file, Task({}, [&](double fraction) { last = fraction; }));
    EXPECT_EQ(last, 0.5);
}

/// A helper that somebody ends while it waits says nothing about the next file.
TEST(HelperPool, AHelperThatIsGoneIsReplacedAndLeavesNoZombie) {
    HelperPool pool(hostile());
    pool.ask(request("wait"), file, {});
    const int first = pool.idleProcesses().front();
    ::kill(first, SIGKILL);
    EXPECT_TRUE(endsSoon(first));
    EXPECT_FALSE(hasZombies());
    EXPECT_EQ(pool.ask(request("wait", "again"), file, {}).bytes, "again");
    EXPECT_NE(pool.idleProcesses().front(), first);
}

TEST(HelperPool, HelpersEndWithTheirPool) {
    int helper = 0;
    {
        HelperPool pool(hostile());
        pool.ask(request("wait"), file, {});
        helper = pool.idleProcesses().front();
    }
    EXPECT_TRUE(endsSoon(helper));
    EXPECT_FALSE(hasZombies());
}

TEST(HelperPool, HelpersEndWithTheProgramHoweverItEnds) {
    std::FILE* const program = ::popen(CHIARO_HOSTILE_HELPER " dies", "r");
    ASSERT_NE(program, nullptr);
    int helper = 0;
    EXPECT_EQ(std::fscanf(program, "%d", &helper), 1);
    ::pclose(program);
    ASSERT_GT(helper, 0);
    EXPECT_TRUE(endsSoon(helper));
}

TEST(HelperPool, WithoutAHelperNothingIsRead) {
    HelperPool missing({.program = "/nowhere/chiaro-import"});
    EXPECT_EQ(
        refusal(missing, "wait"),
        "/nowhere/chiaro-import: is not there, and files are not opened without it; install Chiaro again");
    HelperPool wrong({.program = "/bin/false"});
    EXPECT_EQ(refusal(wrong, "wait"),
              "chiaro-import: does not run (it ended with status 1); install Chiaro again");
}

TEST(HelperPool, ANonsenseLimitIsRefused) {
    EXPECT_THROW(HelperPool({.megabytes = 1}), Error);
    EXPECT_THROW(HelperPool({.seconds = 0}), Error);
    ::setenv("CHIARO_IMPORT_SECONDS", "soon", 1);
    EXPECT_THROW(ImportSettings::fromEnvironment(), Error);
    ::setenv("CHIARO_IMPORT_SECONDS", "7", 1);
    EXPECT_EQ(ImportSettings::fromEnvironment().seconds, 7);
    ::unsetenv("CHIARO_IMPORT_SECONDS");
}

}  // namespace
}  // namespace chiaro::helper
