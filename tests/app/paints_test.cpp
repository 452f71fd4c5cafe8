#include "core/gradient/gradient.h"
#include "tests/app/app_support.h"

#include <QtTest>

using namespace chiaro;
using app::Paints;
using test::Studio;

namespace {

const gradient::ColorPath redPath{{{0, glm::vec3(0)}, {1, {1, 0, 0}}}, gradient::ColorPath::Space::Rgb};

gradient::GradientParams drawnCurve(float y) {
    gradient::GradientParams params;
    params.matchSpeed = false;
    params.curve.points = {{0, 0}, {0.5F, y}, {1, 1}};
    return params;
}

}  // namespace

class PaintsTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

    /// A strip and a mesh that wears it, all made.
    bool fill(Studio& studio) {
        return studio.open({test::writeStrip(m_folder / "strip.png"),
                            test::writeTetrahedron(m_folder / "mesh.obj", "tetrahedron")}) &&
               studio.errors.empty() && studio.paints.state(0).levelsAreFinal;
    }

private Q_SLOTS:
    void everyStageIsMade() {
        Studio studio;
        QVERIFY(fill(studio));
        const Paints::State& state = studio.paints.state(0);
        QCOMPARE(state.scan->image.width(), 160);
        QCOMPARE(state.separated->strip->height(), 48);
        QCOMPARE(state.levels->levels.size(), 4U);
        QCOMPARE(studio.paints.gradient(0).size(), 160U);
        QCOMPARE(studio.paints.synthesisCount(), 1);
    }

    void recolouringIsSeenAtOnceAndSynthesisesNothing() {
        Studio studio;
        QVERIFY(fill(studio));
        const auto levels = studio.paints.state(0).levels;
        QSignalSpy gradientChanged(&studio.paints, &Paints::gradientChanged);
        for (int i = 0; i < 100; ++i) {
            gradient::ColorPath path = redPath;
            path.stops[1].position = 1 - float(i) / 200;
            studio.document.editRecoloring(0, path);
            QVERIFY2(studio.jobs.isIdle(), "a job was started");
        }
        studio.document.finishEdit();
        QCOMPARE(gradientChanged.count(), 100);
        QCOMPARE(studio.paints.gradient(0).back(), glm::vec3(1, 0, 0));
        QVERIFY(studio.settle());
        QCOMPARE(studio.paints.synthesisCount(), 1);
        QCOMPARE(studio.paints.state(0).levels, levels);
    }

    void aSpeedCurveIsFollowedAtOnceAndSynthesisedWhenTheDragEnds() {
        Studio studio;
        QVERIFY(fill(studio));
        studio.document.editGradient(0, drawnCurve(0.2F));
        const glm::vec3 slow = studio.paints.gradient(0)[80];
        studio.document.editGradient(0, drawnCurve(0.8F));
        QVERIFY(studio.paints.gradient(0)[80].r > slow.r + 0.1F);
        QVERIFY(QTest::qWaitFor([&] { return studio.jobs.isIdle(); }, 5000));
        QCOMPARE(studio.paints.synthesisCount(), 1);
        studio.document.finishEdit();
        QVERIFY(studio.settle());
        QCOMPARE(studio.paints.synthesisCount(), 2);
        QVERIFY(studio.paints.state(0).levelsAreFinal);
    }

    void anEditThatRestsIsSynthesisedToo() {
        Studio studio;
        QVERIFY(fill(studio));
        studio.document.editGradient(0, drawnCurve(0.3F));
        QVERIFY(QTest::qWaitFor([&] { return studio.paints.synthesisCount() == 2; }, 5000));
    }

    void undoFindsItsResultStillThere() {
        Studio studio;
        QVERIFY(fill(studio));
        const auto levels = studio.paints.state(0).levels;
        sample::StripParams turned;
        turned.mirror = true;
        studio.document.editStrip(0, turned);
        studio.document.finishEdit();
        QVERIFY(studio.settle());
        QVERIFY(studio.paints.state(0).levels != levels);
        QCOMPARE(studio.paints.synthesisCount(), 2);
        studio.document.undoStack().undo();
        QCOMPARE(studio.paints.state(0).levels, levels);
        QVERIFY(studio.settle());
        QCOMPARE(studio.paints.synthesisCount(), 2);
    }

    void largeLevelsAreSketchedFirst() {
        Studio studio;
        QVERIFY(fill(studio));
        synthesis::LevelParams params = studio.document.project().levels;
        params.size = 320;
        std::vector<int> sizes;
        connect(&studio.paints, &Paints::levelsChanged, this,
                [&](int) { sizes.push_back(studio.paints.state(0).levels->levels[0].width()); });
        studio.document.editLevels(params);
        studio.document.finishEdit();
        QVERIFY(studio.settle());
        QCOMPARE(sizes, (std::vector<int>{128, 320}));
    }

    void paintThatNothingWearsIsNotSynthesised() {
        Studio studio;
        QVERIFY(studio.open({test::writeStrip(m_folder / "alone.png")}));
        QVERIFY(studio.paints.state(0).separated != nullptr);
        QCOMPARE(studio.paints.synthesisCount(), 0);
    }

    void aCancelledSynthesisWaitsToBeAskedFor() {
        Studio studio;
        QVERIFY(fill(studio));
        synthesis::LevelParams params = studio.document.project().levels;
        params.size = 256;
        studio.document.editLevels(params);
        studio.document.finishEdit();
        QVERIFY(!studio.jobs.isIdle());
        studio.jobs.cancelAll();
        QTest::qWait(50);
        QVERIFY(studio.jobs.isIdle());
        QVERIFY(!studio.paints.state(0).levelsAreFinal);
        QVERIFY2(studio.paints.state(0).levels != nullptr, "the old levels stay");
        studio.paints.retry();
        QVERIFY(studio.settle());
        QVERIFY(studio.paints.state(0).levelsAreFinal);
    }

    void aStripThatCantBeCutSaysWhyOnceAndTheFormerStays() {
        Studio studio;
        QVERIFY(fill(studio));
        sample::StripParams tiny;
        tiny.scale = 0.05;
        studio.document.editStrip(0, tiny);
        studio.document.finishEdit();
        QVERIFY(studio.settle());
        QCOMPARE(studio.errors.size(), 1U);
        QVERIFY(studio.paints.state(0).separated != nullptr);
        studio.document.undoStack().undo();
        QVERIFY(studio.settle());
        QVERIFY(studio.paints.state(0).levelsAreFinal);
        QCOMPARE(studio.errors.size(), 1U);
    }
};

QTEST_GUILESS_MAIN(PaintsTest)
#include "paints_test.moc"
