#include "widgets/gradient_curve_editor.h"

#include "widgets/speed_curve_plot.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using gradient::GradientParams;
using gradient::SpeedCurve;
using widgets::GradientCurveEditor;
using widgets::SpeedCurvePlot;

namespace {

const SpeedCurve matched{{{0, 0}, {0.3F, 0.6F}, {1, 1}}};

gradient::Separation greySeparation() {
    gradient::Separation separation;
    for (int x = 0; x < 64; ++x) separation.averages.push_back(glm::vec3(float(x) / 63));
    separation.sorted = separation.averages;
    separation.gradient = separation.averages;
    separation.curve = matched;
    return separation;
}

/// An editor that applies what it is asked for, as the document does.
struct Shown {
    GradientCurveEditor editor;
    GradientParams params;
    int steps = 0;

    explicit Shown(bool matchSpeed) {
        params.matchSpeed = matchSpeed;
        QObject::connect(&editor, &GradientCurveEditor::paramsEdited, &editor,
                         [this](const GradientParams& edited) {
                             params = edited;
                             editor.setParams(params);
                         });
        QObject::connect(&editor, &GradientCurveEditor::editFinished, &editor, [this] { ++steps; });
        const gradient::Separation separation = greySeparation();
        editor.setSeparation(&separation);
        editor.setParams(params);
        editor.resize(360, 420);
        editor.show();
        (void)QTest::qWaitForWindowExposed(&editor);
    }
    SpeedCurvePlot& plot() { return *editor.plot(); }
    void drag(glm::vec2 from, glm::vec2 to) {
        QTest::mousePress(&plot(), Qt::LeftButton, {}, plot().toWidget(from).toPoint());
        QTest::mouseMove(&plot(), plot().toWidget((from + to) / 2.0F).toPoint());
        QTest::mouseMove(&plot(), plot().toWidget(to).toPoint());
        QTest::mouseRelease(&plot(), Qt::LeftButton, {}, plot().toWidget(to).toPoint());
    }
    void doubleClick(glm::vec2 place) {
        QTest::mouseDClick(&plot(), Qt::LeftButton, {}, plot().toWidget(place).toPoint());
        QTest::mouseRelease(&plot(), Qt::LeftButton, {}, plot().toWidget(place).toPoint());
    }
};

bool isMonotone(const SpeedCurve& curve) {
    for (std::size_t i = 1; i < curve.points.size(); ++i)
        if (curve.points[i].x <= curve.points[i - 1].x || curve.points[i].y < curve.points[i - 1].y)
            return false;
    return curve.points.front() == glm::vec2(0, 0) && curve.points.back() == glm::vec2(1, 1);
}

}  // namespace

class GradientCurveEditorTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aDoubleClickAddsAPointThatIsThenDragged() {
        Shown shown(false);
        shown.doubleClick({0.5F, 0.5F});
        QCOMPARE(shown.params.curve.points.size(), 3U);
        shown.drag({0.5F, 0.5F}, {0.3F, 0.7F});
        QVERIFY(glm::distance(shown.params.curve.points[1], {0.3F, 0.7F}) < 0.02F);
        QVERIFY(isMonotone(shown.params.curve));
    }

    void neighboursStopADrag() {
        Shown shown(false);
        shown.params.curve = {{{0, 0}, {0.4F, 0.3F}, {0.7F, 0.6F}, {1, 1}}};
        shown.editor.setParams(shown.params);
        shown.drag({0.4F, 0.3F}, {0.95F, 0.9F});
        QVERIFY(isMonotone(shown.params.curve));
        QVERIFY(shown.params.curve.points[1].x < 0.7F);
        QCOMPARE(shown.params.curve.points[1].y, 0.6F);
        QCOMPARE(shown.steps, 1);
    }

    void theEndsStay() {
        Shown shown(false);
        shown.drag({0, 0}, {0.2F, 0.4F});
        QCOMPARE(shown.params.curve, SpeedCurve{});
        QTest::keyClick(&shown.plot(), Qt::Key_Delete);
        QCOMPARE(shown.params.curve, SpeedCurve{});
    }

    void addMoveDeleteGivesBackWhatWasThere() {
        Shown shown(false);
        const GradientParams before = shown.params;
        shown.doubleClick({0.6F, 0.6F});
        shown.drag({0.6F, 0.6F}, {0.5F, 0.2F});
        QVERIFY(shown.params != before);
        QTest::keyClick(&shown.plot(), Qt::Key_Delete);
        QCOMPARE(shown.params, before);
    }

    void draggingAMatchedCurveTakesItOver() {
        Shown shown(true);
        QCOMPARE(shown.plot().curve(), matched);
        shown.drag({0.3F, 0.6F}, {0.4F, 0.5F});
        QVERIFY(!shown.params.matchSpeed);
        QCOMPARE(shown.params.curve.points.size(), 3U);
        QVERIFY(glm::distance(shown.params.curve.points[1], {0.4F, 0.5F}) < 0.02F);
    }

    void switchingTheMatchingOffKeepsTheMatchedCurve() {
        Shown shown(true);
        shown.editor.findChild<QCheckBox*>("match-speed")->click();
        QVERIFY(!shown.params.matchSpeed);
        QCOMPARE(shown.params.curve, matched);
    }

    void switchingItOnAndOffKeepsTheArtistsCurve() {
        Shown shown(false);
        shown.params.curve = {{{0, 0}, {0.5F, 0.1F}, {1, 1}}};
        shown.editor.setParams(shown.params);
        const SpeedCurve drawn = shown.params.curve;
        auto* match = shown.editor.findChild<QCheckBox*>("match-speed");
        match->click();
        QCOMPARE(shown.plot().curve(), matched);
        match->click();
        QCOMPARE(shown.params.curve, drawn);
    }

    void escapeTakesADragBack() {
        Shown shown(false);
        shown.doubleClick({0.5F, 0.7F});
        const SpeedCurve before = shown.params.curve;
        const glm::vec2 place(0.6F, 0.9F);
        shown.plot().setFocus();
        QTest::mousePress(&shown.plot(), Qt::LeftButton, {},
                          shown.plot().toWidget(before.points[1]).toPoint());
        QTest::mouseMove(&shown.plot(), shown.plot().toWidget(place).toPoint());
        QVERIFY(shown.params.curve != before);
        QTest::keyClick(&shown.plot(), Qt::Key_Escape);
        QCOMPARE(shown.params.curve, before);
        QTest::mouseMove(&shown.plot(), shown.plot().toWidget({0.7F, 0.9F}).toPoint());
        QTest::mouseRelease(&shown.plot(), Qt::LeftButton, {}, shown.plot().toWidget(place).toPoint());
        QCOMPARE(shown.params.curve, before);
        QCOMPARE(shown.steps, 2);
    }

    void numbersMoveTheSelectedPoint() {
        Shown shown(false);
        shown.params.curve = {{{0, 0}, {0.4F, 0.3F}, {1, 1}}};
        shown.editor.setParams(shown.params);
        shown.plot().select(1);
        auto* y = shown.editor.findChild<QDoubleSpinBox*>("point-y");
        y->selectAll();
        QTest::keyClicks(y, "0.75");
        QTest::keyClick(y, Qt::Key_Return);
        QCOMPARE(shown.params.curve.points[1], glm::vec2(0.4F, 0.75F));
    }

    void theKeyboardAloneDoesIt() {
        Shown shown(false);
        QTest::keyClick(&shown.plot(), Qt::Key_PageDown);
        QTest::keyClick(&shown.plot(), Qt::Key_Insert);
        QCOMPARE(shown.params.curve.points.size(), 3U);
        QTest::keyClick(&shown.plot(), Qt::Key_Up, Qt::ShiftModifier);
        QVERIFY(std::abs(shown.params.curve.points[1].y - 0.55F) < 1e-5F);
        QCOMPARE(shown.steps, 2);
    }

    void anEmptyEditorPaintsAndIgnoresThePointer() {
        Shown shown(false);
        shown.editor.setSeparation(nullptr);
        shown.doubleClick({0.5F, 0.5F});
        QCOMPARE(shown.params, GradientParams({.searchScale = 1, .matchSpeed = false, .curve = {}}));
        QVERIFY(!shown.editor.grab().isNull());
    }
};

QTEST_MAIN(GradientCurveEditorTest)
#include "gradient_curve_editor_test.moc"
