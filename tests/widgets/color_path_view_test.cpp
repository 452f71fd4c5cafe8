#include "widgets/color_path_view.h"

#include "core/gradient/color_presets.h"
#include "widgets/color_path_bar.h"
#include "widgets/eyedropper.h"
#include "widgets/path_through.h"
#include "widgets/picture.h"
#include "widgets/strip_view.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using gradient::ColorPath;
using widgets::ColorPathBar;
using widgets::ColorPathView;

namespace {

const ColorPath threeStops{{{0, glm::vec3(0)}, {0.5F, {1, 0, 0}}, {1, glm::vec3(1)}}, ColorPath::Space::Rgb};

/// A view that applies what it is asked for, as the document does.
struct Shown {
    ColorPathView view;
    std::optional<ColorPath> path;
    int steps = 0;

    explicit Shown(std::optional<ColorPath> start) : path(std::move(start)) {
        QObject::connect(&view, &ColorPathView::recoloringEdited, &view,
                         [this](const std::optional<ColorPath>& edited) {
                             path = edited;
                             view.setRecoloring(path);
                         });
        QObject::connect(&view, &ColorPathView::editFinished, &view, [this] { ++steps; });
        gradient::Gradient own;
        for (int x = 0; x < 128; ++x) own.push_back(glm::vec3(float(x) / 127));
        view.setOwnColors(own);
        view.setRecoloring(path);
        view.resize(360, 200);
        view.show();
        (void)QTest::qWaitForWindowExposed(&view);
    }
    ColorPathBar& bar() { return *view.bar(); }
    QToolButton& button(const char* name) { return *view.findChild<QToolButton*>(name); }
    void dragStop(int stop, float to) {
        const QPointF from = bar().handle(stop);
        const QPointF end(bar().toWidget(to), from.y());
        QTest::mousePress(&bar(), Qt::LeftButton, {}, from.toPoint());
        QTest::mouseMove(&bar(), ((from + end) / 2).toPoint());
        QTest::mouseMove(&bar(), end.toPoint());
        QTest::mouseRelease(&bar(), Qt::LeftButton, {}, end.toPoint());
    }
};

/// Presses and lets go at a place on the screen, as whoever has grabbed the mouse hears of it.
void pointAt(QWidget& grabber, QPoint global, Qt::MouseButton button = Qt::LeftButton) {
    const QPointF local = grabber.mapFromGlobal(QPointF(global));
    for (const QEvent::Type type :
         {QEvent::MouseMove, QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
        const bool isMove = type == QEvent::MouseMove;
        QMouseEvent event(type, local, QPointF(global), isMove ? Qt::NoButton : button,
                          type == QEvent::MouseButtonPress ? button : Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(&grabber, &event);
    }
}

}  // namespace

class ColorPathViewTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void controlClickAddsAStopOfThePathsColour() {
        Shown shown(threeStops);
        const QPoint place(int(std::lround(shown.bar().toWidget(0.25F))), 12);
        QTest::mouseClick(&shown.bar(), Qt::LeftButton, Qt::ControlModifier, place);
        QCOMPARE(shown.path->stops.size(), 4U);
        QVERIFY(std::abs(shown.path->stops[1].position - 0.25F) < 0.01F);
        QVERIFY(std::abs(shown.path->stops[1].color.r - 0.5F) < 0.02F);
        QCOMPARE(shown.bar().selected(), 1);
        QCOMPARE(shown.steps, 1);
    }

    void aDragMovesAStopInOneStep() {
        Shown shown(threeStops);
        shown.dragStop(1, 0.8F);
        QVERIFY(std::abs(shown.path->stops[1].position - 0.8F) < 0.01F);
        QCOMPARE(shown.steps, 1);
    }

    void aStopDraggedPastAnotherStaysSelectedAndSorted() {
        Shown shown(threeStops);
        shown.dragStop(0, 0.7F);
        QCOMPARE(shown.bar().selected(), 1);
        QCOMPARE(shown.path->stops[1].color, glm::vec3(0));
        QVERIFY(shown.path->stops[0].position < shown.path->stops[1].position);
    }

    void addMoveDeleteGivesBackWhatWasThere() {
        Shown shown(threeStops);
        const QPoint place(int(std::lround(shown.bar().toWidget(0.3F))), 12);
        QTest::mouseClick(&shown.bar(), Qt::LeftButton, Qt::ControlModifier, place);
        shown.dragStop(1, 0.9F);
        QTest::keyClick(&shown.bar(), Qt::Key_Delete);
        QCOMPARE(shown.path, std::optional(threeStops));
    }

    void theLastStopStays() {
        Shown shown(ColorPath{{{0.5F, {0, 1, 0}}}, ColorPath::Space::Rgb});
        shown.bar().select(0);
        QTest::keyClick(&shown.bar(), Qt::Key_Delete);
        QCOMPARE(shown.path->stops.size(), 1U);
    }

    void flipTwiceAndDistribute() {
        Shown shown(
            ColorPath{{{0, glm::vec3(0)}, {0.25F, {1, 0, 0}}, {1, glm::vec3(1)}}, ColorPath::Space::Rgb});
        const auto before = shown.path;
        shown.button("flip").click();
        QCOMPARE(shown.path->stops[1].position, 0.75F);
        QCOMPARE(shown.path->stops[0].color, glm::vec3(1));
        shown.button("flip").click();
        QCOMPARE(shown.path, before);
        shown.button("distribute").click();
        QCOMPARE(shown.path->stops[1].position, 0.5F);
        QCOMPARE(shown.steps, 3);
    }

    void aTypedPositionMovesTheStop() {
        Shown shown(threeStops);
        shown.bar().select(1);
        auto* field = shown.view.findChild<QDoubleSpinBox*>("stop-position");
        field->selectAll();
        QTest::keyClicks(field, "0.125");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(shown.path->stops[1].position, 0.125F);
    }

    void cancellingTheColourDialogBringsTheColourBack() {
        Shown shown(threeStops);
        const QPointF handle = shown.bar().handle(1);
        QTest::mouseDClick(&shown.bar(), Qt::LeftButton, {}, handle.toPoint());
        auto* dialog = shown.view.findChild<QColorDialog*>();
        QVERIFY(dialog != nullptr);
        dialog->setCurrentColor(Qt::blue);
        QCOMPARE(shown.path->stops[1].color, glm::vec3(0, 0, 1));
        dialog->reject();
        QCOMPARE(shown.path, std::optional(threeStops));
    }

    void acceptingItIsOneStep() {
        Shown shown(threeStops);
        shown.bar().select(1);
        QTest::keyClick(&shown.bar(), Qt::Key_Return);
        auto* dialog = shown.view.findChild<QColorDialog*>();
        QVERIFY(dialog != nullptr);
        dialog->setCurrentColor(Qt::green);
        dialog->setCurrentColor(Qt::blue);
        dialog->accept();
        QCOMPARE(shown.path->stops[1].color, glm::vec3(0, 0, 1));
        QCOMPARE(shown.steps, 1);
    }

    void switchingOnStartsNearTheOwnColoursAndOffGoesBack() {
        Shown shown(std::nullopt);
        auto* recolour = shown.view.findChild<QCheckBox*>("recolour");
        recolour->click();
        QVERIFY(shown.path.has_value());
        for (float x : {0.0F, 0.3F, 0.8F, 1.0F})
            QVERIFY(glm::distance(shown.path->at(x), glm::vec3(x)) < 0.03F);
        recolour->click();
        QVERIFY(!shown.path.has_value());
    }

    void presetsAreOneStepAndGoFromDarkToLight() {
        Shown shown(std::nullopt);
        shown.button("preset-0").click();
        QCOMPARE(shown.steps, 1);
        QVERIFY(shown.path.has_value());
        for (const gradient::ColorPreset& preset : gradient::colorPresets()) {
            const glm::vec3 weights(0.2126F, 0.7152F, 0.0722F);
            float last = -1;
            for (const gradient::ColorStop& stop : preset.path.stops) {
                const float luminance = glm::dot(stop.color, weights);
                QVERIFY2(luminance > last, preset.name);
                last = luminance;
            }
        }
    }

    void interpolationIsChosen() {
        Shown shown(threeStops);
        auto* space = shown.view.findChild<QComboBox*>("space");
        QTest::keyClick(space, Qt::Key_Down);
        QCOMPARE(shown.path->space, ColorPath::Space::Oklab);
    }

    void stopsAreCopiedAsTextAndPastedFromAny() {
        Shown shown(threeStops);
        shown.bar().setFocus();
        QTest::keyClick(&shown.bar(), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QGuiApplication::clipboard()->text(), QString("0 #000000, 0.5 #ff0000, 1 #ffffff"));
        QGuiApplication::clipboard()->setText("1 #fff0b0,\n  0 #201040\n");
        QTest::keyClick(&shown.bar(), Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(shown.path->stops.size(), 2U);
        QCOMPARE(shown.path->stops[0].position, 0.0F);
        QCOMPARE(shown.steps, 1);
        QTest::mouseClick(&shown.button("duplicate"), Qt::LeftButton);
        QCOMPARE(QGuiApplication::clipboard()->text(), QString("0 #201040, 1 #fff0b0"));
    }

    void aPasteThatIsNoPathSaysWhyAndChangesNothing() {
        Shown shown(threeStops);
        auto* note = shown.view.findChild<QLabel*>("paste-note");
        for (const char* text : {"", "hello", "0 #12", "2 #ffffff", "0 red, 1 blue"}) {
            QGuiApplication::clipboard()->setText(text);
            shown.view.paste();
            QCOMPARE(shown.path, std::optional(threeStops));
            QVERIFY(note->isVisible());
            QVERIFY2(note->text().contains("#"), qPrintable(note->text()));
        }
        QCOMPARE(shown.steps, 0);
        shown.dragStop(1, 0.8F);
        QVERIFY(!note->isVisible());
    }

    void pastingRecoloursASampleThatShowsItsOwnColours() {
        Shown shown(std::nullopt);
        shown.view.copy();
        QVERIFY(QGuiApplication::clipboard()->text().startsWith("0 #000000"));
        QGuiApplication::clipboard()->setText("0 #ff0000, 1 #00ff00");
        shown.view.paste();
        QVERIFY(shown.path.has_value());
        QCOMPARE(shown.path->stops[1].color, glm::vec3(0, 1, 0));
    }

    void escapeTakesADragBack() {
        Shown shown(threeStops);
        shown.bar().setFocus();
        const QPointF from = shown.bar().handle(1);
        QTest::mousePress(&shown.bar(), Qt::LeftButton, {}, from.toPoint());
        QTest::mouseMove(&shown.bar(), (from + QPointF(60, 0)).toPoint());
        QVERIFY(shown.path != std::optional(threeStops));
        QTest::keyClick(&shown.bar(), Qt::Key_Escape);
        QCOMPARE(shown.path, std::optional(threeStops));
        QTest::mouseMove(&shown.bar(), (from + QPointF(90, 0)).toPoint());
        QTest::mouseRelease(&shown.bar(), Qt::LeftButton, {}, (from + QPointF(90, 0)).toPoint());
        QCOMPARE(shown.path, std::optional(threeStops));
    }

    void theEyedropperTakesColoursFromTheScreen() {
        Shown shown(threeStops);
        QWidget ground;
        ground.setStyleSheet("background: #3264c8;");
        ground.setGeometry(600, 300, 120, 120);
        ground.show();
        QVERIFY(QTest::qWaitForWindowExposed(&ground));
        shown.bar().select(1);
        QToolButton& button = shown.button("eyedropper");
        const QPoint place = ground.mapToGlobal(QPoint(60, 60));
        // What is on the screen reaches it a little later.
        const QColor wanted(0x32, 0x64, 0xc8);
        QTRY_COMPARE(widgets::toColor(widgets::Eyedropper::colorAt(place).value_or(glm::vec3(0))), wanted);
        QTest::mouseClick(&button, Qt::LeftButton);
        QVERIFY(shown.view.eyedropper()->isActive());
        QVERIFY(QWidget::mouseGrabber() == &button);
        pointAt(button, place);
        QVERIFY(!shown.view.eyedropper()->isActive());
        QCOMPARE(widgets::toColor(shown.path->stops[1].color), wanted);
        QCOMPARE(shown.steps, 1);
        QVERIFY(QWidget::mouseGrabber() == nullptr);
    }

    void theEyedropperTakesColoursFromAStripAsItIs() {
        Shown shown(threeStops);
        auto pictures = std::make_shared<widgets::StripPictures>();
        pictures->strip = ColorImage(2, 1, glm::vec3(0.2F, 0.4F, 0.6F));
        pictures->strip(1, 0) = glm::vec3(1, 0.6F, 0.2F);
        pictures->texture = ColorImage(2, 1);
        pictures->averages = pictures->gradient = {glm::vec3(0), glm::vec3(1)};
        widgets::StripView strip;
        strip.setPictures(pictures);
        strip.setGeometry(500, 300, 300, 180);
        strip.show();
        QVERIFY(QTest::qWaitForWindowExposed(&strip));
        QVERIFY(!strip.colorAt({2, 10}).has_value());
        QCOMPARE(strip.colorAt({290, 10}), std::optional(glm::vec3(1, 0.6F, 0.2F)));
        shown.bar().select(1);
        QTest::mouseClick(&shown.button("eyedropper"), Qt::LeftButton);
        pointAt(shown.button("eyedropper"), strip.mapToGlobal(QPoint(290, 10)));
        QCOMPARE(shown.path->stops[1].color, glm::vec3(1, 0.6F, 0.2F));
    }

    void escapeEndsTheEyedropperWithoutAColour() {
        Shown shown(threeStops);
        shown.bar().select(1);
        QToolButton& button = shown.button("eyedropper");
        for (const bool byKey : {true, false}) {
            QTest::mouseClick(&button, Qt::LeftButton);
            QVERIFY(shown.view.eyedropper()->isActive());
            if (byKey)
                QTest::keyClick(&button, Qt::Key_Escape);
            else
                pointAt(button, {5, 5}, Qt::RightButton);
            QVERIFY(!shown.view.eyedropper()->isActive());
            QVERIFY(QWidget::keyboardGrabber() == nullptr);
        }
        QCOMPARE(shown.path, std::optional(threeStops));
        QCOMPARE(shown.steps, 0);
    }

    void theKeyboardAlonePicks() {
        Shown shown(threeStops);
        shown.bar().select(1);
        QToolButton& button = shown.button("eyedropper");
        button.setFocus();
        QCursor::setPos(shown.view.mapToGlobal(QPoint(2, 2)));
        QTest::keyClick(&button, Qt::Key_Space);
        QVERIFY(shown.view.eyedropper()->isActive());
        const QPoint before = QCursor::pos();
        QTest::keyClick(&button, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(QCursor::pos() - before, QPoint(10, 0));
        const auto under = widgets::Eyedropper::colorAt(QCursor::pos());
        QTest::keyClick(&button, Qt::Key_Return);
        QVERIFY(!shown.view.eyedropper()->isActive());
        QCOMPARE(std::optional(shown.path->stops[1].color), under);
    }

    void aPathThroughColoursIsAsCloseAsItSays() {
        std::vector<glm::vec3> bent;
        for (int x = 0; x < 200; ++x) bent.push_back({float(x) / 199, x < 100 ? 0 : float(x - 100) / 99, 0});
        const ColorPath path = widgets::pathThrough(bent);
        QCOMPARE(path.stops.size(), 3U);
        for (int x = 0; x < 200; ++x)
            QVERIFY(glm::distance(path.at(float(x) / 199), bent[std::size_t(x)]) < 0.013F);
    }
};

QTEST_MAIN(ColorPathViewTest)
#include "color_path_view_test.moc"
