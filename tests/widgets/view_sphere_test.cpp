#include "widgets/view_sphere.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using widgets::ViewSphere;

namespace {

constexpr double tolerance = 1e-9;

/// A sphere that faces +Z, with a view there, one to the right and one behind.
struct Shown : ViewSphere {
    Shown() {
        setViews({{{0, 0, 2}, 1, 1, false, "first"},
                  {{1, 0, 0.4}, 2, 1, true, "second"},
                  {{0.3, 0.4, -1}, 3, 2, false, "third"}});
        face({0, 0, 1});
        resize(240, 240);
        show();
        (void)QTest::qWaitForWindowExposed(this);
    }
    QPoint place(int view) { return position(views()[std::size_t(view)].direction).toPoint(); }
    void drag(QPoint from, QPoint by) {
        QTest::mousePress(this, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 5; ++i) QTest::mouseMove(this, from + by * i / 5);
        QTest::mouseRelease(this, Qt::LeftButton, {}, from + by);
    }
};

glm::dvec3 directionOf(const QSignalSpy& moves) {
    return moves.last().at(1).value<glm::dvec3>();
}

}  // namespace

class ViewSphereTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qRegisterMetaType<glm::dvec3>("glm::dvec3"); }

    void directionsLieWhereTheEyeExpectsThem() {
        Shown sphere;
        const QPointF center = QRectF(sphere.rect()).center();
        QVERIFY(QLineF(sphere.position({0, 0, 5}), center).length() < tolerance);
        QVERIFY(sphere.position({1, 0, 0}).x() > center.x() + 80);
        QVERIFY(sphere.position({0, 1, 0}).y() < center.y() - 80);
        QVERIFY(sphere.isNear({0, 0, 1}));
        QVERIFY(!sphere.isNear({0, 0, -1}));
        sphere.face({1, 0, 0});
        QVERIFY(QLineF(sphere.position({1, 0, 0}), center).length() < 1e-6);
    }

    void aClickSelectsAndBesideItSelectsNone() {
        Shown sphere;
        QSignalSpy selections(&sphere, &ViewSphere::selectionChanged);
        QTest::mouseClick(&sphere, Qt::LeftButton, {}, sphere.place(1));
        QCOMPARE(sphere.selected(), 1);
        QTest::mouseClick(&sphere, Qt::LeftButton, {}, sphere.place(2));  // on the far side
        QCOMPARE(sphere.selected(), 2);
        QTest::mouseClick(&sphere, Qt::LeftButton, {}, QPoint(60, 170));
        QCOMPARE(sphere.selected(), -1);
        QCOMPARE(selections.size(), 3);
    }

    void aDragMovesTheViewUnderThePointer() {
        Shown sphere;
        QSignalSpy moves(&sphere, &ViewSphere::viewMoved);
        QSignalSpy ends(&sphere, &ViewSphere::editFinished);
        const QPoint from = sphere.place(0);
        sphere.drag(from, {30, -20});
        QVERIFY(moves.size() > 1);
        QCOMPARE(ends.size(), 1);
        const glm::dvec3 moved = directionOf(moves);
        QVERIFY(std::abs(glm::length(moved) - 1) < tolerance);
        const QPointF there = sphere.position(moved);
        QVERIFY(QLineF(there, QPointF(from + QPoint(30, -20))).length() < 1);
        QVERIFY(sphere.isNear(moved));
        QCOMPARE(sphere.views()[0].direction, glm::dvec3(0, 0, 2));  // it changes nothing by itself
    }

    void aViewOnTheFarSideStaysThere() {
        Shown sphere;
        QSignalSpy moves(&sphere, &ViewSphere::viewMoved);
        sphere.drag(sphere.place(2), {15, 15});
        QVERIFY(!sphere.isNear(directionOf(moves)));
    }

    void aViewIsNeverDraggedOffTheSphere() {
        Shown sphere;
        QSignalSpy moves(&sphere, &ViewSphere::viewMoved);
        sphere.drag(sphere.place(0), {400, 0});
        QVERIFY(glm::distance(directionOf(moves), glm::dvec3(1, 0, 0)) < 0.01);
    }

    void aPressThatHardlyMovesIsNoDrag() {
        Shown sphere;
        QSignalSpy moves(&sphere, &ViewSphere::viewMoved);
        QSignalSpy ends(&sphere, &ViewSphere::editFinished);
        sphere.drag(sphere.place(0), {1, 1});
        QCOMPARE(moves.size(), 0);
        QCOMPARE(ends.size(), 0);
        QCOMPARE(sphere.selected(), 0);
    }

    void aDragBesideTheViewsTurnsTheSphere() {
        Shown sphere;
        QSignalSpy moves(&sphere, &ViewSphere::viewMoved);
        const double before = sphere.position({0, 0, 1}).x();
        sphere.drag({60, 170}, {40, 0});
        QCOMPARE(moves.size(), 0);
        QVERIFY(sphere.position({0, 0, 1}).x() > before + 10);
    }

    void theKeyboardAloneIsEnough() {
        Shown sphere;
        sphere.setFocus();
        QSignalSpy moves(&sphere, &ViewSphere::viewMoved);
        QSignalSpy ends(&sphere, &ViewSphere::editFinished);
        QSignalSpy removals(&sphere, &ViewSphere::removeWanted);
        QSignalSpy locks(&sphere, &ViewSphere::lockWanted);
        QTest::keyClick(&sphere, Qt::Key_Tab);
        QCOMPARE(sphere.selected(), 0);
        QTest::keyClick(&sphere, Qt::Key_Right);
        QCOMPARE(moves.size(), 1);
        QCOMPARE(ends.size(), 1);
        QVERIFY(directionOf(moves).x > 0.08 && directionOf(moves).x < 0.09);  // sin 5°
        QTest::keyClick(&sphere, Qt::Key_Up, Qt::ShiftModifier);
        QVERIFY(std::abs(directionOf(moves).y - std::sin(3.14159265358979 / 180)) < 1e-6);
        QTest::keyClick(&sphere, Qt::Key_Tab);
        QTest::keyClick(&sphere, Qt::Key_Tab);
        QCOMPARE(sphere.selected(), 2);
        QVERIFY(sphere.isNear(sphere.views()[2].direction));  // turned so that it is seen
        QTest::keyClick(&sphere, Qt::Key_Return);
        QTest::keyClick(&sphere, Qt::Key_Delete);
        QCOMPARE(locks.last().at(0).toInt(), 2);
        QCOMPARE(removals.last().at(0).toInt(), 2);
        QTest::keyClick(&sphere, Qt::Key_Escape);
        QCOMPARE(sphere.selected(), -1);
        const QPointF before = sphere.position({0, 0, 1});
        QTest::keyClick(&sphere, Qt::Key_Left);
        QVERIFY(sphere.position({0, 0, 1}) != before);
        QCOMPARE(moves.size(), 2);
    }

    void aScreenReaderHearsWhichViewIsSelected() {
        Shown sphere;
        QCOMPARE(sphere.accessibleDescription(), QString("3 views"));
        sphere.setSelected(1);
        QCOMPARE(sphere.accessibleDescription(), QString("View 2 of 3, placed"));
        sphere.setViews({});
        QCOMPARE(sphere.selected(), -1);
    }

    void placedAndPlannedViewsDifferInShape() {
        Shown sphere;
        sphere.setViews({{{0, 0, 1}, 1, 1, false, {}}});
        const QPoint corner = sphere.place(0) + QPoint(7, 7);
        const QImage planned = sphere.grab().toImage();
        sphere.setViews({{{0, 0, 1}, 1, 1, true, {}}});
        const QImage placed = sphere.grab().toImage();
        const QRgb beside = planned.pixel(corner + QPoint(6, 6));
        const auto away = [&](const QImage& image) {
            return std::abs(qGray(image.pixel(corner)) - qGray(beside));
        };
        QVERIFY(away(planned) < 20);
        QVERIFY(away(placed) > 20);
    }
};

QTEST_MAIN(ViewSphereTest)
#include "view_sphere_test.moc"
