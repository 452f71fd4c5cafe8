#include "widgets/sample_view.h"

#include "widgets/crop_canvas.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using widgets::CropCanvas;
using widgets::CropQuad;
using widgets::SampleView;

namespace {

const CropQuad wholeScan{glm::vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}};

void drag(QWidget& widget, QPointF from, QPointF to) {
    QTest::mousePress(&widget, Qt::LeftButton, {}, from.toPoint());
    QTest::mouseMove(&widget, ((from + to) / 2).toPoint());
    QTest::mouseMove(&widget, to.toPoint());
    QTest::mouseRelease(&widget, Qt::LeftButton, {}, to.toPoint());
}

/// A view that applies what it is asked for, as the document does.
struct Shown {
    SampleView view;
    sample::StripParams params;
    int steps = 0;

    Shown() {
        QObject::connect(&view, &SampleView::paramsEdited, &view, [this](const sample::StripParams& edited) {
            params = edited;
            view.setParams(params);
        });
        QObject::connect(&view, &SampleView::editFinished, &view, [this] { ++steps; });
        view.setScan(QImage(400, 200, QImage::Format_RGB32), {800, 400});
        view.resize(420, 320);
        view.show();
        (void)QTest::qWaitForWindowExposed(&view);
    }
    CropCanvas& canvas() { return *view.canvas(); }
};

bool near(glm::vec2 a, glm::vec2 b, float tolerance = 0.01F) {
    return glm::distance(a, b) < tolerance;
}

}  // namespace

class SampleViewTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cornersFollowThePointer() {
        Shown shown;
        drag(shown.canvas(), shown.canvas().toWidget({0, 0}), shown.canvas().toWidget({0.25F, 0.1F}));
        QVERIFY(near(shown.params.crop[0], {0.25F, 0.1F}));
        for (std::size_t corner : {1U, 2U, 3U}) QCOMPARE(shown.params.crop[corner], wholeScan[corner]);
        QCOMPARE(shown.steps, 1);
    }

    void edgesMoveTheirTwoCorners() {
        Shown shown;
        drag(shown.canvas(), shown.canvas().toWidget({0.5F, 1}), shown.canvas().toWidget({0.5F, 0.75F}));
        QVERIFY(near(shown.params.crop[2], {1, 0.75F}));
        QVERIFY(near(shown.params.crop[3], {0, 0.75F}));
        QCOMPARE(shown.params.crop[0], wholeScan[0]);
    }

    void theWholeStopsAtTheBorderInShape() {
        Shown shown;
        shown.params.crop = {glm::vec2{0.2F, 0.2F}, {0.6F, 0.2F}, {0.6F, 0.6F}, {0.2F, 0.6F}};
        shown.view.setParams(shown.params);
        drag(shown.canvas(), shown.canvas().toWidget({0.4F, 0.4F}), shown.canvas().toWidget({1.2F, 0.5F}));
        QVERIFY(near(shown.params.crop[0], {0.6F, 0.3F}));
        QVERIFY(near(shown.params.crop[2], {1, 0.7F}));
    }

    void aCornerCannotFoldTheQuadrilateral() {
        Shown shown;
        drag(shown.canvas(), shown.canvas().toWidget({0, 0}), shown.canvas().toWidget({0.9F, 0.9F}));
        QVERIFY(widgets::isUsableCrop(shown.params.crop));
        QVERIFY2(shown.params.crop[0].x > 0.4F, "it goes as far as it can");
    }

    void arrowKeysNudgeByAScanPixel() {
        Shown shown;
        QTest::keyClick(&shown.canvas(), Qt::Key_1);
        QTest::keyClick(&shown.canvas(), Qt::Key_Right);
        QVERIFY(near(shown.params.crop[0], {1.0F / 800, 0}, 1e-6F));
        QTest::keyClick(&shown.canvas(), Qt::Key_Down, Qt::ShiftModifier);
        QVERIFY(near(shown.params.crop[0], {1.0F / 800, 10.0F / 400}, 1e-6F));
        QCOMPARE(shown.steps, 2);
    }

    void keysReachEveryEdgeAndTheWhole() {
        Shown shown;
        shown.canvas().setCrop({glm::vec2{0.25F, 0.25F}, {0.75F, 0.25F}, {0.75F, 0.75F}, {0.25F, 0.75F}});
        QTest::keyClick(&shown.canvas(), Qt::Key_6);  // the right one
        QTest::keyClick(&shown.canvas(), Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(near(shown.params.crop[1], {0.75F - 10.0F / 800, 0.25F}, 1e-6F));
        QVERIFY(near(shown.params.crop[2], {0.75F - 10.0F / 800, 0.75F}, 1e-6F));
        QVERIFY(near(shown.params.crop[0], {0.25F, 0.25F}, 1e-6F));
        QTest::keyClick(&shown.canvas(), Qt::Key_0);
        QTest::keyClick(&shown.canvas(), Qt::Key_Up);
        QVERIFY(near(shown.params.crop[3], {0.25F, 0.75F - 1.0F / 400}, 1e-6F));
        QCOMPARE(shown.steps, 2);
    }

    void escapeTakesADragBack() {
        Shown shown;
        shown.canvas().setFocus();
        const QPointF from = shown.canvas().toWidget({1, 1}), to = shown.canvas().toWidget({0.7F, 0.8F});
        QTest::mousePress(&shown.canvas(), Qt::LeftButton, {}, from.toPoint());
        QTest::mouseMove(&shown.canvas(), to.toPoint());
        QVERIFY(shown.params.crop != wholeScan);
        QTest::keyClick(&shown.canvas(), Qt::Key_Escape);
        QCOMPARE(shown.params.crop, wholeScan);
        QTest::mouseMove(&shown.canvas(), from.toPoint());
        QTest::mouseRelease(&shown.canvas(), Qt::LeftButton, {}, to.toPoint());
        QCOMPARE(shown.params.crop, wholeScan);
        QCOMPARE(shown.steps, 1);
    }

    void buttonsTurnAndMirror() {
        Shown shown;
        shown.view.findChild<QToolButton*>("turn-right")->click();
        QCOMPARE(shown.params.quarterTurns, 1);
        shown.view.findChild<QToolButton*>("turn-left")->click();
        shown.view.findChild<QToolButton*>("turn-left")->click();
        QCOMPARE(shown.params.quarterTurns, 3);
        shown.view.findChild<QToolButton*>("mirror")->click();
        QVERIFY(shown.params.mirror);
        QCOMPARE(shown.steps, 4);
    }

    void resetBringsTheWholeScanBack() {
        Shown shown;
        auto* reset = shown.view.findChild<QToolButton*>("crop-reset");
        QVERIFY(!reset->isEnabled());
        shown.params.crop[0] = {0.1F, 0.1F};
        shown.view.setParams(shown.params);
        reset->click();
        QCOMPARE(shown.params, sample::StripParams{});
    }

    void syncingEmitsNothing() {
        Shown shown;
        QSignalSpy edited(&shown.view, &SampleView::paramsEdited);
        sample::StripParams params;
        params.mirror = true;
        params.scale = 2;
        params.crop[0] = {0.3F, 0.3F};
        shown.view.setParams(params);
        QCOMPARE(edited.count(), 0);
    }

    void crossedAndReversedQuadsAreRefused() {
        QVERIFY(widgets::isUsableCrop(wholeScan));
        QVERIFY(!widgets::isUsableCrop({glm::vec2{0, 0}, {0, 1}, {1, 1}, {1, 0}}));
        QVERIFY(!widgets::isUsableCrop({glm::vec2{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
        QVERIFY(!widgets::isUsableCrop({glm::vec2{0, 0}, {1.2F, 0}, {1, 1}, {0, 1}}));
    }
};

QTEST_MAIN(SampleViewTest)
#include "sample_view_test.moc"
