#include "app/jobs/job_runner.h"

#include "app/jobs/memo.h"
#include "core/base/error.h"

#include <QtTest>

#include <atomic>
#include <chrono>
#include <thread>

using namespace chiaro;
using app::JobRunner;
using app::Memo;

namespace {

/// Works until it is cancelled.
int endless(const Task& task) {
    for (double done = 0;; done = std::min(0.9, done + 0.01)) {
        task.checkpoint();
        task.report(done);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

bool waitUntilIdle(JobRunner& jobs) {
    return QTest::qWaitFor([&] { return jobs.isIdle(); }, 10'000);
}

}  // namespace

class JobRunnerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void resultsArriveOnTheCallersThread() {
        JobRunner jobs;
        int result = 0;
        QThread* arrived = nullptr;
        std::atomic<QThread*> worked = nullptr;
        jobs.start(
            {"Counting", {}, {}, {}},
            [&worked](const Task&) {
                worked = QThread::currentThread();
                return 42;
            },
            [&](int value) {
                result = value;
                arrived = QThread::currentThread();
            });
        QVERIFY(!jobs.isIdle());
        QVERIFY(waitUntilIdle(jobs));
        QCOMPARE(result, 42);
        QCOMPARE(arrived, QThread::currentThread());
        QVERIFY(worked.load() != arrived);
    }

    void aNewerJobOfTheSameSlotReplacesTheOlder() {
        JobRunner jobs;
        std::vector<int> results;
        const auto keep = [&](int value) { results.push_back(value); };
        jobs.start({"Old", "levels", {}, {}}, endless, keep);
        jobs.start(
            {"New", "levels", {}, {}}, [](const Task&) { return 2; }, keep);
        QCOMPARE(jobs.jobs().size(), 1U);
        QVERIFY(waitUntilIdle(jobs));
        QTest::qWait(30);
        QCOMPARE(results, std::vector<int>{2});
    }

    void aResultThatIsReadyButSupersededIsDropped() {
        JobRunner jobs;
        std::atomic<bool> worked = false;
        bool shown = false;
        jobs.start(
            {"Old", "strip", {}, {}}, [&worked](const Task&) { return worked = true, 1; },
            [&](int) { shown = true; });
        while (!worked) std::this_thread::yield();
        jobs.supersede("strip");
        QTest::qWait(30);
        QVERIFY(!shown);
    }

    void cancellingTellsItAndComesBackQuickly() {
        JobRunner jobs;
        bool cancelled = false;
        bool done = false;
        const int number =
            jobs.start({"Endless", {}, {}, [&] { cancelled = true; }}, endless, [&](int) { done = true; });
        QTest::qWait(30);
        QElapsedTimer timer;
        timer.start();
        jobs.cancel(number);
        QVERIFY(jobs.isIdle());
        QVERIFY(cancelled);
        QVERIFY(!done);
        QVERIFY2(timer.elapsed() < 200, "cancelling blocks");
    }

    void errorsArriveAsSentences() {
        JobRunner jobs;
        QString message;
        const auto fails = [](const Task&) -> int { throw Error("strip.png", "is empty", "scan it again"); };
        QSignalSpy failed(&jobs, &JobRunner::failed);
        jobs.start({"Reading", {}, [&](const QString& text) { message = text; }, {}}, fails, [](int) {});
        QVERIFY(waitUntilIdle(jobs));
        QCOMPARE(message, "strip.png: is empty; scan it again");
        QCOMPARE(failed.count(), 0);
        jobs.start({"Reading", {}, {}, {}}, fails, [](int) {});
        QVERIFY(waitUntilIdle(jobs));
        QCOMPARE(failed.count(), 1);
    }

    void progressIsSeen() {
        JobRunner jobs;
        jobs.start({"Endless", {}, {}, {}}, endless, [](int) {});
        QVERIFY(QTest::qWaitFor([&] { return jobs.jobs().front().progress > 0.05; }, 5000));
        jobs.cancelAll();
        QVERIFY(jobs.isIdle());
    }

    void aRunnerGoesAwayWithItsJobs() {
        QElapsedTimer timer;
        {
            JobRunner jobs;
            for (int i = 0; i < 8; ++i) jobs.start({"Endless", {}, {}, {}}, endless, [](int) {});
            timer.start();
        }
        QVERIFY(timer.elapsed() < 1000);
    }

    void theMemoForgetsTheLeastRecentlyUsed() {
        Memo memo(100);
        memo.insert(1, std::make_shared<const int>(10), 40);
        memo.insert(2, std::make_shared<const int>(20), 40);
        QVERIFY(memo.find<int>(1));
        memo.insert(3, std::make_shared<const int>(30), 40);
        QCOMPARE(*memo.find<int>(1), 10);
        QVERIFY(!memo.find<int>(2));
        QCOMPARE(*memo.find<int>(3), 30);
        QCOMPARE(memo.bytes(), 80U);
        memo.insert(4, std::make_shared<const int>(40), 500);
        QCOMPARE(*memo.find<int>(4), 40);
        QCOMPARE(memo.bytes(), 500U);
    }

    void quietJobsAreNotListedButAwaited() {
        JobRunner jobs;
        bool isDone = false;
        jobs.start(
            {"Measuring", "view", {}, {}, true}, [](const Task&) { return 1; }, [&](int) { isDone = true; });
        QVERIFY(jobs.jobs().empty());
        QVERIFY(!jobs.isIdle() && jobs.isRunning("view"));
        jobs.cancelAll();  // what the artist can't see goes on
        QTRY_VERIFY(isDone);
        QVERIFY(jobs.isIdle());
    }
};

QTEST_GUILESS_MAIN(JobRunnerTest)
#include "job_runner_test.moc"
