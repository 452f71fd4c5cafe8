#include "app/view_measures.h"

#include "core/project/pipeline.h"
#include "tests/app/app_support.h"

#include <QtTest>

using namespace chiaro;
using app::ViewMeasures;
using test::Studio;

namespace {

/// A painted tetrahedron, as a viewport of 160 x 160 pixels would show it.
struct Measured {
    Studio studio;
    widgets::ViewState state;
    int looks = 0;  ///< how often it was asked what is shown
    ViewMeasures measures{studio.jobs, studio.paints, [this] { return snapshots(); }};
    QSignalSpy told{&measures, &ViewMeasures::measureChanged};

    explicit Measured(const test::TemporaryFolder& folder) {
        studio.open({test::writeStrip(folder / "strip.png"),
                     test::writeTetrahedron(folder / "mesh.obj", "tetrahedron")});
        show();
    }
    void show() {
        state.setScene(studio.meshes.scene());
        state.camera = project::cameraFor(studio.document.project(), studio.meshes.scene());
        state.setPaint(0, {studio.paints.state(0).levels, studio.paints.gradient(0)});
        measures.restart();
    }
    std::vector<widgets::ViewSnapshot> snapshots() {
        ++looks;
        std::vector<widgets::ViewSnapshot> snapshots;
        for (const std::string& method : state.shownMethods())
            snapshots.push_back(widgets::ViewSnapshot::of(state, method, {160, 160}));
        return snapshots;
    }
    /// Waits until a map is being made, and does something in that moment.
    bool onceAMapIsMade(const std::function<void()>& act) {
        bool isDone = false;
        const auto watch = QObject::connect(&measures, &ViewMeasures::mapChanged, &measures, [&] {
            if (isDone || !measures.mapProgress()) return;
            isDone = true;
            act();
        });
        const bool came = QTest::qWaitFor([&] { return isDone; }, 10'000);
        QObject::disconnect(watch);
        return came;
    }
    bool settled() {
        return QTest::qWaitFor([this] { return studio.jobs.isIdle() && !measures.isWaiting(); }, 30'000);
    }
};

}  // namespace

class ViewMeasuresTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

private Q_SLOTS:
    void nobodyWhoAsksNothingIsMeasured() {
        Measured one(m_folder);
        QTest::qWait(600);
        QCOMPARE(one.looks, 0);
        QVERIFY(!one.measures.measure());
    }

    void figuresComeOnceThePictureRests() {
        Measured one(m_folder);
        one.measures.setLive(true);
        for (int i = 0; i < 6; ++i) {
            QTest::qWait(40);
            one.state.camera.azimuth += 5;
            one.measures.restart();
        }
        QCOMPARE(one.looks, 0);
        QVERIFY(one.settled());
        QCOMPARE(one.looks, 1);
        QVERIFY(one.measures.measure());
        QCOMPARE(one.measures.measure()->similarity.count, 100U);
        QVERIFY(one.measures.measure()->similarity.mean > 0);
        QVERIFY(one.measures.measure()->similarity.mean < 0.5);
        QVERIFY(one.measures.measure()->shadingAbsolute);
        QVERIFY(!one.measures.heatMap());
        QVERIFY(one.studio.errors.empty());
    }

    void theSamePictureGivesTheSameFigures() {
        Measured one(m_folder);
        one.measures.setLive(true);
        QVERIFY(one.settled());
        const double before = one.measures.measure()->similarity.mean;
        one.measures.restart();
        QVERIFY2(!one.measures.measure(), "what was measured before is not of the picture of now");
        QVERIFY(one.settled());
        QCOMPARE(one.measures.measure()->similarity.mean, before);
    }

    void paintThatIsNotTheStripsIsTold() {
        Measured one(m_folder);
        one.measures.setLive(true);
        QVERIFY(one.settled());
        const metrics::FrameMeasure before = *one.measures.measure();
        // The strip is dark to light; this picture is as light as the strip is dark.
        gradient::Gradient reversed = one.studio.paints.gradient(0);
        std::ranges::reverse(reversed);
        one.state.setGradient(0, reversed);
        one.measures.restart();
        QVERIFY(one.settled());
        QVERIFY(one.measures.measure()->shadingAbsolute->mean > 2 * before.shadingAbsolute->mean);
    }

    void aStaleResultIsNeverSeen() {
        Measured one(m_folder);
        one.measures.setLive(true);
        bool isChanged = false;
        connect(&one.studio.jobs, &app::JobRunner::jobsChanged, &one.measures, [&] {
            if (isChanged || !one.studio.jobs.isRunning(ViewMeasures::slot)) return;
            isChanged = true;
            one.state.camera.distance = 4;  // a quarter of the size
            one.measures.restart();
        });
        QTRY_VERIFY_WITH_TIMEOUT(isChanged, 5000);
        QVERIFY(!one.studio.jobs.isRunning(ViewMeasures::slot));
        one.told.clear();
        QVERIFY(one.settled());
        QCOMPARE(one.told.count(), 1);
        QCOMPARE(one.looks, 2);
    }

    void aCoarseMapComesFirst() {
        Measured one(m_folder);
        std::vector<std::shared_ptr<const widgets::HeatMap>> maps;
        std::vector<bool> final;
        connect(&one.measures, &ViewMeasures::mapChanged, &one.measures, [&] {
            const auto map = one.measures.heatMap();
            if (!map || (!maps.empty() && maps.back() == map)) return;
            maps.push_back(map);
            final.push_back(one.measures.isMapFinal());
        });
        one.measures.setMap(ViewMeasures::Map::Similarity);
        QVERIFY(one.settled());
        QCOMPARE(maps.size(), 2U);
        QVERIFY(!final[0] && final[1]);
        QCOMPARE(maps[1]->values.width(), 160);
        QCOMPARE(maps[1]->picture.size(), QSize(160, 160));
        QVERIFY(maps[1]->strips[0].size == QSize(160, 48));
        QVERIFY(std::ranges::any_of(maps[1]->values.pixels(), [](float value) { return value > 0; }));
        // The other map was made along with it.
        const int looks = one.looks;
        one.measures.setMap(ViewMeasures::Map::Shading);
        QVERIFY(one.studio.jobs.isIdle());
        QCOMPARE(one.measures.heatMap()->title, QString("Shading error"));
        QCOMPARE(one.looks, looks);
        one.measures.setMap(ViewMeasures::Map::None);
        QVERIFY(!one.measures.heatMap());
    }

    void aMapThatIsNoLongerWantedIsNotMade() {
        Measured one(m_folder);
        one.measures.setMap(ViewMeasures::Map::Similarity);
        QVERIFY(one.onceAMapIsMade([&] { one.measures.setMap(ViewMeasures::Map::None); }));
        QVERIFY(!one.studio.jobs.isRunning(ViewMeasures::slot));
        QVERIFY(!one.measures.mapProgress());
    }

    void aCancelledMapCanBeAskedForAgain() {
        Measured one(m_folder);
        one.measures.setMap(ViewMeasures::Map::Similarity);
        QVERIFY(one.onceAMapIsMade([&] { one.studio.jobs.cancelAll(); }));
        QVERIFY(!one.measures.mapProgress());
        one.measures.setMap(ViewMeasures::Map::None);
        one.measures.setMap(ViewMeasures::Map::Similarity);
        QVERIFY(one.settled());
        QVERIFY(one.measures.isMapFinal());
    }

    void anObjectTooSmallIsSaidInASentence() {
        Measured one(m_folder);
        one.state.camera.distance = 90;
        one.measures.setLive(true);
        QVERIFY(one.settled());
        QVERIFY(!one.measures.measure());
        QVERIFY2(one.measures.problem().contains("smaller block"), qPrintable(one.measures.problem()));
        QVERIFY2(one.studio.errors.empty(), "nobody asked, so nobody is told off");
    }

    void measuringNeverHoldsTheWindowUp() {
        Measured one(m_folder);
        qint64 longest = std::numeric_limits<qint64>::max();
        for (int attempt = 0; attempt < 3 && longest >= 50; ++attempt) {
            const test::Watchdog watchdog;
            one.measures.setMap(ViewMeasures::Map::Similarity);
            one.measures.restart();
            QVERIFY(one.settled());
            longest = std::min(longest, watchdog.longest());
        }
        QVERIFY2(longest < 50, qPrintable(QString("%1 ms without an event").arg(longest)));
    }
};

QTEST_MAIN(ViewMeasuresTest)
#include "view_measures_test.moc"
