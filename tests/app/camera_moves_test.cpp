#include "app/camera_moves.h"

#include "app/document.h"
#include "widgets/viewport/viewport.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;

namespace {

/// A viewport and the history of its camera.
struct Moves {
    app::Document document;
    widgets::Viewport viewport;
    app::CameraMoves moves{document, viewport, nullptr};
    const scene::Camera start = viewport.camera();

    Moves() { viewport.resize(300, 200); }
    void drag(QPoint by) {
        const QPointF from(100, 100);
        QTest::mousePress(&viewport, Qt::LeftButton, {}, from.toPoint());
        for (int step = 1; step <= 4; ++step) {
            const QPointF at = from + QPointF(by) * step / 4;
            QMouseEvent move(QEvent::MouseMove, at, viewport.mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                             {});
            QApplication::sendEvent(&viewport, &move);
        }
        QTest::mouseRelease(&viewport, Qt::LeftButton, {}, from.toPoint() + by);
    }
    void back() { moves.previousAction()->trigger(); }
    void forth() { moves.nextAction()->trigger(); }
};

}  // namespace

class CameraMovesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aDragIsOneMove() {
        Moves one;
        QVERIFY(!one.moves.previousAction()->isEnabled());
        one.drag({40, 0});
        const scene::Camera first = one.viewport.camera();
        one.drag({0, 30});
        const scene::Camera second = one.viewport.camera();
        one.back();
        QCOMPARE(one.viewport.camera(), first);
        one.back();
        QCOMPARE(one.viewport.camera(), one.start);
        QVERIFY(!one.moves.previousAction()->isEnabled());
        one.forth();
        one.forth();
        QCOMPARE(one.viewport.camera(), second);
        QVERIFY(!one.moves.nextAction()->isEnabled());
    }

    void keysThatFollowEachOtherAreOneMove() {
        Moves one;
        for (int i = 0; i < 3; ++i) QTest::keyClick(&one.viewport, Qt::Key_Left);
        QTest::qWait(700);
        const scene::Camera turned = one.viewport.camera();
        QTest::keyClick(&one.viewport, Qt::Key_7, Qt::KeypadModifier);
        QCOMPARE(one.viewport.camera().elevation, 90.0F);
        one.back();
        QCOMPARE(one.viewport.camera(), turned);
        one.back();
        QCOMPARE(one.viewport.camera(), one.start);
    }

    void aNewMoveForgetsWhatWasTakenBack() {
        Moves one;
        one.drag({40, 0});
        one.back();
        QVERIFY(one.moves.nextAction()->isEnabled());
        one.drag({0, 20});
        QVERIFY(!one.moves.nextAction()->isEnabled());
        one.back();
        QCOMPARE(one.viewport.camera(), one.start);
    }

    void itIsNoEditOfTheDocument() {
        Moves one;
        QSignalSpy edited(&one.viewport, &widgets::Viewport::cameraEdited);
        one.drag({40, 0});
        one.back();
        QCOMPARE(edited.last().at(0).value<scene::Camera>(), one.start);
        QCOMPARE(one.document.undoStack().count(), 0);
        one.drag({40, 0});
        one.document.replace({}, {}, {});
        QVERIFY2(!one.moves.previousAction()->isEnabled(), "another project, other cameras");
    }

    void aMoveThatLedNowhereIsForgotten() {
        widgets::CameraHistory history;
        scene::Camera camera;
        history.beginMove(camera);
        history.endMove(camera);
        QVERIFY(!history.canGoBack());
        for (int i = 0; i < 250; ++i) {
            history.beginMove(camera);
            camera.azimuth += 1;
            history.endMove(camera);
        }
        int steps = 0;
        while (const auto there = history.back(camera)) {
            camera = *there;
            ++steps;
        }
        QCOMPARE(steps, 100);
    }
};

QTEST_MAIN(CameraMovesTest)
#include "camera_moves_test.moc"
