#include "app/docks/timeline_dock.h"

#include "app/playback.h"
#include "tests/app/app_support.h"
#include "widgets/timeline.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using scene::Path;
using test::Studio;

namespace {

struct Stage {
    Studio studio;
    app::Playback playback{studio.document, studio.meshes};
    QMainWindow window;
    app::TimelineDock* dock = new app::TimelineDock(studio.document, playback);

    Stage() {
        window.addDockWidget(Qt::BottomDockWidgetArea, dock);
        window.resize(700, 300);
        window.show();
        (void)QTest::qWaitForWindowExposed(&window);
        scene::Camera camera;
        camera.azimuth = 30;
        studio.document.setCamera(camera);
    }
    const project::Animation& animation() { return studio.document.project().animation; }
    QUndoStack& undo() { return studio.document.undoStack(); }
    template <class Widget>
    Widget& find(const char* name) {
        return *dock->findChild<Widget*>(name);
    }
    void look(float azimuth) {
        scene::Camera camera = playback.view().camera;
        camera.azimuth = azimuth;
        playback.takeCamera(camera);
    }
    float azimuth() { return playback.view().camera.azimuth; }
};

}  // namespace

class TimelineDockTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void keysAreSetWhereTheArtistLooks() {
        Stage stage;
        stage.look(10);
        stage.dock->keyCamera();
        stage.dock->setCurrentFrame(11);
        stage.look(50);
        stage.find<QToolButton>("key-camera").click();
        QCOMPARE(stage.animation().path.keyFrames(Path::Part::Camera), (std::vector{1, 11}));
        QCOMPARE(stage.undo().count(), 2);
        stage.find<QComboBox>("interpolation").setCurrentIndex(1);
        Q_EMIT stage.find<QComboBox>("interpolation").activated(1);
        stage.dock->setCurrentFrame(6);
        QCOMPARE(stage.azimuth(), 30.0F);
        stage.look(77);
        stage.dock->setCurrentFrame(1);
        QCOMPARE(stage.azimuth(), 10.0F);  // keys win at the next frame
        while (stage.undo().canUndo()) stage.undo().undo();
        QCOMPARE(stage.animation(), project::Animation{});
    }

    void theTurntableStartsFromWhereTheArtistLooksAtAnyFrame() {
        Stage stage;
        stage.find<QToolButton>("turntable").click();
        QCOMPARE(stage.animation().path.cameraTurn, 7.5);
        stage.dock->setCurrentFrame(5);
        QCOMPARE(stage.azimuth(), 60.0F);
        stage.look(100);
        QCOMPARE(stage.azimuth(), 100.0F);
        stage.dock->setCurrentFrame(1);
        QCOMPARE(stage.azimuth(), 70.0F);
        stage.find<QToolButton>("turntable").click();
        QVERIFY(!stage.animation().path.moves());
    }

    void moreFramesKeepTurnsOnceAround() {
        Stage stage;
        stage.find<QToolButton>("light-sweep").click();
        auto& frames = stage.find<QSpinBox>("frames");
        frames.setValue(96);
        QCOMPARE(stage.animation().frames, 96);
        QCOMPARE(stage.animation().lastFrame, 96);
        QCOMPARE(stage.animation().path.lightTurn, 3.75);
        stage.find<QSpinBox>("last").setValue(50);
        frames.setValue(200);
        QCOMPARE(stage.animation().lastFrame, 50);
        frames.setValue(20);
        QCOMPARE(stage.animation().lastFrame, 20);
        stage.find<QSpinBox>("first").setValue(10);
        QCOMPARE(stage.animation().firstFrame, 10);
    }

    void turningALightThatHasKeysKeysIt() {
        Stage stage;
        stage.playback.takeLight(0, {1, 0, 0});
        QCOMPARE(stage.studio.document.project().lights[0].vector, glm::vec3(1, 0, 0));
        stage.studio.document.finishEdit();
        stage.dock->keyLight();
        stage.dock->setCurrentFrame(9);
        stage.playback.takeLight(0, {0, 1, 0});
        stage.playback.takeLight(0, {0, 0, 1});
        stage.studio.document.finishEdit();
        QCOMPARE(stage.studio.document.project().lights[0].vector, glm::vec3(1, 0, 0));
        QCOMPARE(stage.animation().path.keyFrames(Path::Part::Light), (std::vector{1, 9}));
        QCOMPARE(stage.playback.view().lights[0].vector, glm::vec3(0, 0, 1));
        QCOMPARE(stage.undo().count(), 3);
    }

    void aLightIsTurnedBackFromTheSweep() {
        Stage stage;
        stage.find<QToolButton>("light-sweep").click();
        stage.dock->setCurrentFrame(13);  // a quarter of the way around
        stage.playback.takeLight(0, {1, 0, 0});
        QVERIFY(glm::distance(stage.playback.view().lights[0].vector, glm::vec3(1, 0, 0)) < 1e-5F);
        QVERIFY(glm::distance(stage.studio.document.project().lights[0].vector, glm::vec3(0, 0, 1)) < 1e-5F);
    }

    void lookingElsewhereLastsUntilTheNextFrame() {
        Stage stage;
        stage.dock->keyCamera();
        stage.look(77);
        stage.playback.takeLight(0, {1, 0, 0});  // no reason to look back
        QCOMPARE(stage.azimuth(), 77.0F);
        stage.dock->setCurrentFrame(2);
        QCOMPARE(stage.azimuth(), 30.0F);
        stage.look(77);
        stage.undo().undo();
        stage.undo().undo();  // the key
        QCOMPARE(stage.azimuth(), 77.0F);
        QVERIFY(!stage.animation().path.moves());
    }

    void keysAreMovedAndRemovedOnTheTimeline() {
        Stage stage;
        stage.dock->setCurrentFrame(10);
        stage.dock->keyCamera();
        widgets::Timeline& timeline = *stage.dock->timeline();
        const QPoint from = timeline.positionOf({0, 10}).toPoint(),
                     to = timeline.positionOf({0, 30}).toPoint();
        QTest::mousePress(&timeline, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 5; ++i) QTest::mouseMove(&timeline, from + (to - from) * i / 5);
        QTest::mouseRelease(&timeline, Qt::LeftButton, {}, to);
        QCOMPARE(stage.animation().path.keyFrames(Path::Part::Camera), std::vector{30});
        QCOMPARE(stage.undo().count(), 2);
        QTest::keyClick(&timeline, Qt::Key_Delete);
        QVERIFY(!stage.animation().path.moves());
        stage.undo().undo();
        stage.undo().undo();
        QCOMPARE(stage.animation().path.keyFrames(Path::Part::Camera), std::vector{10});
    }

    void playingGoesThroughTheRenderRangeInTime() {
        Stage stage;
        project::Animation animation = stage.animation();
        animation.rate = 100;
        animation.firstFrame = 10;
        animation.lastFrame = 19;
        stage.studio.document.editAnimation(animation, "test");
        QSignalSpy frames(&stage.playback, &app::Playback::currentFrameChanged);
        stage.dock->togglePlaying();
        QVERIFY(stage.playback.isPlaying());
        QTest::qWait(400);
        stage.dock->togglePlaying();
        QVERIFY(!stage.playback.isPlaying());
        QVERIFY(frames.count() > 5);
        for (const auto& frame : frames) QVERIFY(frame[0].toInt() >= 10 && frame[0].toInt() <= 19);
    }

    void theRateIsThatOfThePictures() {
        Stage stage;
        QSignalSpy rates(&stage.playback, &app::Playback::rateMeasured);
        stage.playback.countPicture();
        QCOMPARE(rates.count(), 0);  // nothing plays
        stage.playback.setPlaying(true);
        for (int i = 0; i < 12; ++i) {
            QTest::qWait(50);
            stage.playback.countPicture();
        }
        QVERIFY(!rates.isEmpty());
        const double rate = rates.last()[0].toDouble();
        QVERIFY2(rate > 5 && rate < 21, qPrintable(QString::number(rate)));
        QVERIFY(stage.find<QLabel>("measured-rate").text().contains("fps"));
        stage.playback.setPlaying(false);
    }

    void anotherProjectStartsAtItsFirstFrame() {
        Stage stage;
        stage.dock->setCurrentFrame(20);
        stage.playback.setPlaying(true);
        stage.studio.document.replace({}, {}, {});
        QCOMPARE(stage.playback.currentFrame(), 1);
        QVERIFY(!stage.playback.isPlaying());
        QCOMPARE(stage.find<QSpinBox>("frame").value(), 1);
        stage.dock->setCurrentFrame(1000);
        QCOMPARE(stage.playback.currentFrame(), 48);
    }
};

QTEST_MAIN(TimelineDockTest)
#include "timeline_dock_test.moc"
