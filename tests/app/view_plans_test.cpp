#include "app/view_plans.h"

#include "core/project/pipeline.h"
#include "tests/app/app_support.h"

#include <QtTest>

using namespace chiaro;
using app::ViewPlans;
using test::Studio;

namespace {

/// A studio that shows a tetrahedron of which plans are wanted.
struct Planned : Studio {
    explicit Planned(const test::TemporaryFolder& folder) {
        viewPlans.setWanted(&document, true);
        views::ViewParams params;
        params.count = 4;
        params.size = 64;
        document.editViews(params);
        document.finishEdit();
        isReady = open({test::writeTetrahedron(folder / "mesh.obj", "tetrahedron")}) && settled();
    }
    bool settled() {
        return QTest::qWaitFor([this] { return jobs.isIdle() && viewPlans.plan(0) != nullptr; }, 10'000);
    }
    /// Of a mesh this small it is over at the next look.
    bool planningBegins() { return QSignalSpy(&jobs, &app::JobRunner::jobsChanged).wait() && !jobs.isIdle(); }
    bool isReady = false;
};

const project::PlacedView fromTheRight{{1, 0.2F, 0.1F}, {0, 1, 0}};

}  // namespace

class ViewPlansTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

private Q_SLOTS:
    void nothingIsPlannedUntilSomebodyWantsIt() {
        Studio studio;
        QVERIFY(studio.open({test::writeTetrahedron(m_folder / "mesh.obj", "tetrahedron")}));
        QCOMPARE(studio.viewPlans.planCount(), 0);
        QVERIFY(!studio.viewPlans.plan(0));
        studio.document.editMethod("view-dependent");
        QTRY_VERIFY(studio.viewPlans.plan(0));
        QCOMPARE(studio.viewPlans.planCount(), 1);
    }

    void thePlanIsWhatCoreMakes() {
        Planned studio(m_folder);
        QVERIFY(studio.isReady);
        const auto made = project::planObject(studio.document.project(), studio.meshes.scene(), 0, {});
        const auto shown = studio.viewPlans.plan(0);
        QVERIFY(shown->planned->plan == made->plan);
        QCOMPARE(shown->coverage.covered, 1.0);
        QCOMPARE(shown->coverage.views.size(), made->plan.groups.size());
    }

    void planningKeepsPlacedViews() {
        Planned studio(m_folder);
        QVERIFY(studio.isReady);
        QCOMPARE(studio.document.addView(0, fromTheRight), 0);
        studio.document.finishEdit();
        QVERIFY(!studio.viewPlans.plan(0));
        QVERIFY(studio.viewPlans.lastPlan(0));
        QVERIFY(studio.settled());
        const std::vector<views::FaceGroup>& groups = studio.viewPlans.plan(0)->planned->plan.groups;
        QVERIFY(groups[0].view.locked);
        QVERIFY(groups[0].view.direction == glm::dvec3(fromTheRight.direction));
        QVERIFY(!groups[1].view.locked);
        QCOMPARE(groups.size(), 4U);
    }

    void undoFindsThePlanStillThere() {
        Planned studio(m_folder);
        QVERIFY(studio.isReady);
        const auto before = studio.viewPlans.plan(0);
        studio.document.addView(0, fromTheRight);
        studio.document.finishEdit();
        QVERIFY(studio.settled());
        const int made = studio.viewPlans.planCount();
        studio.document.undoStack().undo();
        QCOMPARE(studio.viewPlans.plan(0), before);
        QTest::qWait(250);
        QCOMPARE(studio.viewPlans.planCount(), made);
    }

    void aDragIsPlannedWhenItRests() {
        Planned studio(m_folder);
        QVERIFY(studio.isReady);
        const int made = studio.viewPlans.planCount();
        const int view = studio.document.addView(0, fromTheRight);
        project::PlacedView moved = fromTheRight;
        for (int i = 0; i < 40; ++i) {
            moved.direction.y = float(i) / 40;
            studio.document.moveView(0, view, moved);
            QTest::qWait(2);
        }
        studio.document.finishEdit();
        QCOMPARE(studio.document.undoStack().index(), 3);  // parameters, mesh, view
        QVERIFY(studio.settled());
        QVERIFY2(studio.viewPlans.planCount() - made <= 3, "the drag was planned step by step");
        QVERIFY(studio.viewPlans.plan(0)->planned->plan.groups[0].view.direction ==
                glm::dvec3(moved.direction));
    }

    void aStalePlanIsDropped() {
        Planned studio(m_folder);
        QVERIFY(studio.isReady);
        const auto before = studio.viewPlans.plan(0);
        views::ViewParams params = studio.document.project().views;
        params.count = 7;
        studio.document.editViews(params);
        QVERIFY(studio.planningBegins());
        studio.document.undoStack().undo();
        QVERIFY(studio.jobs.isIdle());
        QTest::qWait(250);
        QCOMPARE(studio.viewPlans.lastPlan(0), before);
        QCOMPARE(studio.viewPlans.plan(0), before);
    }

    void anotherMeshForgetsThePlanAtOnce() {
        Planned studio(m_folder);
        QVERIFY(studio.isReady);
        studio.document.replace({}, {}, {});
        QVERIFY(!studio.viewPlans.lastPlan(0));
        QCOMPARE(studio.viewPlans.objectCount(), 0);
        QVERIFY(studio.jobs.isIdle());
    }

    void aCancelledPlanWaitsToBeAskedFor() {
        Planned studio(m_folder);
        QVERIFY(studio.isReady);
        studio.document.addView(0, fromTheRight);
        studio.document.finishEdit();
        QVERIFY(studio.planningBegins());
        studio.jobs.cancelAll();
        QTest::qWait(250);
        QVERIFY(!studio.viewPlans.plan(0));
        QVERIFY(studio.jobs.isIdle());
        studio.viewPlans.retry();
        QVERIFY(studio.settled());
    }

    void anErrorIsToldOnceAndTheLastPlanStays() {
        Planned studio(m_folder);
        QVERIFY(studio.isReady);
        views::ViewParams params = studio.document.project().views;
        params.count = 0;  // which no form gives
        studio.document.editViews(params);
        studio.document.finishEdit();
        QTRY_COMPARE(studio.errors.size(), 1U);
        QTest::qWait(250);
        QCOMPARE(studio.errors.size(), 1U);
        QVERIFY(studio.viewPlans.lastPlan(0));
        QVERIFY(!studio.viewPlans.plan(0));
    }

    void editsOfViewsAreUndoneOneByOne() {
        Planned studio(m_folder);
        QVERIFY(studio.isReady);
        app::Document& document = studio.document;
        const project::Project before = document.project();
        document.addView(0, fromTheRight);
        document.finishEdit();
        document.lockView(0, {{0, 0, 1}, {0, 1, 0}});
        document.finishEdit();
        const std::vector<project::PlacedView> two = document.placedViews(0);
        QCOMPARE(two.size(), 2U);
        document.removeView(0, 0);
        document.finishEdit();
        QCOMPARE(document.placedViews(0).size(), 1U);
        document.undoStack().undo();
        QVERIFY(document.placedViews(0) == two);
        document.undoStack().undo();
        document.undoStack().undo();
        QVERIFY(document.project() == before);
    }
};

QTEST_GUILESS_MAIN(ViewPlansTest)
#include "view_plans_test.moc"
