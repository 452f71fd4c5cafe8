#include "widgets/timeline.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using widgets::Timeline;

namespace {

/// 48 frames, two lanes; edits are shown as an owner would.
struct Shown {
    Timeline timeline;
    int first = 5;
    int last = 40;
    int finished = 0;

    Shown() {
        timeline.setFrames(48, first, last);
        timeline.setLanes({{"Camera", {1, 20, 48}}, {"Light", {10}}});
        timeline.resize(600, timeline.sizeHint().height());
        QObject::connect(&timeline, &Timeline::currentFrameEdited, &timeline, &Timeline::setCurrentFrame);
        QObject::connect(&timeline, &Timeline::editFinished, &timeline, [this] { ++finished; });
        QObject::connect(&timeline, &Timeline::rangeEdited, &timeline,
                         [this](int from, int to) { timeline.setFrames(48, first = from, last = to); });
        QObject::connect(&timeline, &Timeline::keyMoved, &timeline, [this](int lane, int from, int to) {
            auto lanes = timeline.lanes();
            std::ranges::replace(lanes[std::size_t(lane)].keys, from, to);
            std::ranges::sort(lanes[std::size_t(lane)].keys);
            timeline.setLanes(lanes);
        });
        timeline.show();
        (void)QTest::qWaitForWindowExposed(&timeline);
    }
    void drag(QPointF from, QPointF to) {
        QTest::mousePress(&timeline, Qt::LeftButton, {}, from.toPoint());
        for (int i = 1; i <= 10; ++i) QTest::mouseMove(&timeline, (from + (to - from) * i / 10).toPoint());
        QTest::mouseRelease(&timeline, Qt::LeftButton, {}, to.toPoint());
    }
    QPointF ruler(int frame) { return {timeline.positionOf(frame), 5}; }
};

}  // namespace

class TimelineTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void draggingTheRulerGoesThroughTheFrames() {
        Shown shown;
        shown.drag(shown.ruler(3), shown.ruler(30));
        QCOMPARE(shown.timeline.currentFrame(), 30);
        shown.drag(shown.ruler(30), shown.ruler(30) + QPointF(900, 0));
        QCOMPARE(shown.timeline.currentFrame(), 48);
        QCOMPARE(shown.finished, 0);  // looking is no edit
    }

    void aKeyIsSelectedAndMovedInOneStep() {
        Shown shown;
        shown.drag(shown.timeline.positionOf({0, 20}), shown.timeline.positionOf({0, 33}));
        QCOMPARE(shown.timeline.lanes()[0].keys, (std::vector{1, 33, 48}));
        QCOMPARE(shown.timeline.selectedKey(), (Timeline::Key{0, 33}));
        QCOMPARE(shown.finished, 1);
    }

    void aKeyPassesOverAnotherWithoutHarm() {
        Shown shown;
        shown.drag(shown.timeline.positionOf({0, 20}), shown.timeline.positionOf({0, 48}));
        const auto& keys = shown.timeline.lanes()[0].keys;
        QCOMPARE(keys.size(), 3U);
        QCOMPARE(keys[2], 48);
        QVERIFY(keys[1] > 40 && keys[1] < 48);
    }

    void theRangeHasEndsToDrag() {
        Shown shown;
        const double y = 19;
        shown.drag({shown.timeline.positionOf(5) - 2, y}, {shown.timeline.positionOf(12), y});
        QCOMPARE(shown.first, 12);
        shown.drag({shown.timeline.positionOf(40) + 2, y}, {shown.timeline.positionOf(1), y});
        QCOMPARE(shown.last, 12);  // never before the first
        QCOMPARE(shown.finished, 2);
    }

    void keysGoFromFrameToFrame() {
        Shown shown;
        const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
            QTest::keyClick(&shown.timeline, key, modifiers);
            return shown.timeline.currentFrame();
        };
        QCOMPARE(press(Qt::Key_Left), 1);
        QCOMPARE(press(Qt::Key_Right), 2);
        QCOMPARE(press(Qt::Key_Right, Qt::ShiftModifier), 12);
        QCOMPARE(press(Qt::Key_Up), 20);
        QCOMPARE(press(Qt::Key_Up), 48);
        QCOMPARE(press(Qt::Key_Up), 48);
        QCOMPARE(press(Qt::Key_Home), 1);
        QCOMPARE(press(Qt::Key_End), 48);
        QCOMPARE(press(Qt::Key_Down), 20);
        QCOMPARE(press(Qt::Key_Down), 10);
    }

    void deleteAsksForTheSelectedKeyAlone() {
        Shown shown;
        QSignalSpy removed(&shown.timeline, &Timeline::keyRemoveWanted);
        QTest::keyClick(&shown.timeline, Qt::Key_Delete);
        QCOMPARE(removed.count(), 0);
        QTest::mouseClick(&shown.timeline, Qt::LeftButton, {}, shown.timeline.positionOf({1, 10}).toPoint());
        QTest::keyClick(&shown.timeline, Qt::Key_Delete);
        QCOMPARE(removed.count(), 1);
        QCOMPARE(removed[0][0].toInt(), 1);
        QCOMPARE(removed[0][1].toInt(), 10);
        shown.timeline.setLanes({{"Camera", {1}}, {"Light", {}}});
        QVERIFY(!shown.timeline.selectedKey());
    }

    void aSingleFrameAndNoLaneAreFine() {
        Timeline timeline;
        timeline.setFrames(1, 1, 1);
        timeline.resize(300, 40);
        timeline.show();
        QVERIFY(QTest::qWaitForWindowExposed(&timeline));
        QTest::mouseClick(&timeline, Qt::LeftButton, {}, {200, 5});
        QCOMPARE(timeline.currentFrame(), 1);
        QVERIFY(!timeline.grab().isNull());
    }
};

QTEST_MAIN(TimelineTest)
#include "timeline_test.moc"
