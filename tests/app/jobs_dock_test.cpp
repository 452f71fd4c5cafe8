#include "app/docks/jobs_dock.h"

#include "app/docks/history_dock.h"
#include "app/job_model.h"
#include "core/base/error.h"
#include "tests/app/app_support.h"

#include <QAbstractItemModelTester>
#include <QtTest>
#include <QtWidgets>

#include <thread>

using namespace chiaro;
using app::JobModel;
using app::JobRunner;

namespace {

/// Works until it is cancelled, half done.
int endless(const Task& task) {
    task.report(0.5);
    for (;;) {
        task.checkpoint();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

QString textOf(const JobModel& model, int row, JobModel::Column column) {
    return model.data(model.index(row, column)).toString();
}

}  // namespace

class JobsDockTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatRunsIsListedAndCancelled() {
        JobRunner jobs;
        app::JobsDock dock(jobs);
        JobModel& model = dock.model();
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        jobs.start({"Painting oil", "a", {}, {}}, endless, [](int) {});
        jobs.start({"Painting chalk", "b", {}, {}}, endless, [](int) {});
        QCOMPARE(model.runningCount(), 2);
        QCOMPARE(textOf(model, 0, JobModel::Title), "Painting oil");
        QTRY_COMPARE(textOf(model, 1, JobModel::State), "50 %");
        QVERIFY(qFuzzyCompare(model.data(model.index(1, JobModel::State), JobModel::ProgressRole).toDouble(),
                              0.5));
        QTRY_VERIFY(textOf(model, 0, JobModel::Time).endsWith("left"));
        dock.list()->setCurrentIndex(model.index(1, 0));
        QElapsedTimer timer;
        timer.start();
        QTest::keyClick(dock.list(), Qt::Key_Delete);
        QCOMPARE(model.runningCount(), 1);
        QVERIFY(timer.elapsed() < 200);
        QCOMPARE(textOf(model, 1, JobModel::Title), "Painting chalk");
        QCOMPARE(textOf(model, 1, JobModel::State), "cancelled");
        dock.findChild<QToolButton*>("close")->click();
        QCOMPARE(model.runningCount(), 0);
        QCOMPARE(model.rowCount(), 2);
        dock.findChild<QToolButton*>("remove")->click();
        QCOMPARE(model.rowCount(), 0);
    }

    void aFailureSaysWhy() {
        JobRunner jobs;
        app::JobsDock dock(jobs);
        jobs.start(
            {"Reading head.obj", {}, {}, {}},
            [](const Task&) -> int { throw Error("head.obj", "is torn", "choose a whole one"); }, [](int) {});
        QTRY_VERIFY(jobs.isIdle());
        QCOMPARE(dock.model().rowCount(), 1);
        QCOMPARE(textOf(dock.model(), 0, JobModel::State), "head.obj: is torn; choose a whole one");
    }

    void shortAndSupersededWorkIsNotListed() {
        JobRunner jobs;
        app::JobsDock dock(jobs);
        jobs.start(
            {"Blinking", {}, {}, {}}, [](const Task&) { return 1; }, [](int) {});
        QTRY_VERIFY(jobs.isIdle());
        jobs.start({"Older", "slot", {}, {}}, endless, [](int) {});
        jobs.start({"Newer", "slot", {}, {}}, endless, [](int) {});
        QCOMPARE(dock.model().rowCount(), 1);
        QCOMPARE(textOf(dock.model(), 0, JobModel::Title), "Newer");
        jobs.cancelAll();
    }

    void theHistoryGoesBackAndForth() {
        test::Studio studio;
        app::HistoryDock dock(studio.document.undoStack());
        dock.show();
        auto* view = dock.findChild<QUndoView*>("history");
        studio.document.editMethod("image-based");
        studio.document.finishEdit();
        studio.document.editLight(0, {1, 0, 0});
        studio.document.finishEdit();
        QCOMPARE(view->model()->rowCount(), 3);
        view->setCurrentIndex(view->model()->index(1, 0));
        QCOMPARE(studio.document.project().lights[0].vector, scene::Light{}.vector);
        QCOMPARE(studio.document.project().method, std::string("image-based"));
        view->setCurrentIndex(view->model()->index(0, 0));
        QCOMPARE(studio.document.project().method, project::Project{}.method);
    }
};

QTEST_MAIN(JobsDockTest)
#include "jobs_dock_test.moc"
