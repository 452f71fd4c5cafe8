#include "app/compare_tools.h"

#include "app/docks/gradient_dock.h"
#include "app/heat_maps.h"
#include "app/main_window.h"
#include "app/metric_tools.h"
#include "tests/app/app_support.h"
#include "widgets/color_path_bar.h"
#include "widgets/color_path_view.h"
#include "widgets/compare_view.h"
#include "widgets/viewport/heat_overlay.h"
#include "widgets/viewport/viewport.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using app::MainWindow;
using Mode = widgets::Composition::Mode;

namespace {

/// Mean red minus blue over the middle of a part of a picture, which lies between shares of its width.
double warmth(const QImage& picture, double from, double to) {
    const double width = (to - from) * picture.width();
    const QRect part(int(from * picture.width() + width * 0.4), picture.height() * 2 / 5, int(width * 0.2),
                     picture.height() / 5);
    double sum = 0;
    for (int y = part.top(); y <= part.bottom(); ++y)
        for (int x = part.left(); x <= part.right(); ++x)
            sum += qRed(picture.pixel(x, y)) - qBlue(picture.pixel(x, y));
    return sum / (double(part.width()) * part.height());
}

}  // namespace

/// Comparing methods in the studio's window.
class CompareToolsTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;
    std::unique_ptr<MainWindow> m_window;

    app::CompareTools& compare() { return m_window->compare(); }
    bool settle() {
        return QTest::qWaitFor([&] { return m_window->jobs().isIdle(); }, 120'000);
    }
    void open() {
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1200, 700);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->activateWindow();
        m_window->open(
            {QString::fromStdString(test::writeStrip(m_folder / "strip.png", 320, 96).string()),
             QString::fromStdString(test::writeTetrahedron(m_folder / "mesh.obj", "one").string())});
        QVERIFY(settle());
        views::ViewParams views = m_window->document().project().views;
        views.size = 96;
        m_window->document().editViews(views);
        m_window->viewport().frameAll();
        m_window->viewport().setFocus();
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&m_window->viewport(), key, modifiers);
    }

private Q_SLOTS:
    void initTestCase() {
        Q_INIT_RESOURCE(resources);
        QCoreApplication::setOrganizationName("ChiaroTests");
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                           QString::fromStdString(m_folder.path().string()));
    }
    void init() {
        QSettings().clear();
        open();
    }
    void cleanup() {
        m_window->document().undoStack().setClean();
        m_window.reset();
    }

    void keysAloneCompare() {
        QCOMPARE(compare().composition().mode, Mode::Single);
        const int edits = m_window->document().undoStack().count();
        press(Qt::Key_3, Qt::ControlModifier);
        QCOMPARE(compare().composition().mode, Mode::Wipe);
        QCOMPARE(m_window->viewport().shownMethods().size(), 2U);
        const double x = compare().composition().wipeCenter.x;
        press(Qt::Key_BracketRight);
        QVERIFY(compare().composition().wipeCenter.x > x);
        press(Qt::Key_BracketLeft);
        QVERIFY(std::abs(compare().composition().wipeCenter.x - x) < 1e-9);
        press(Qt::Key_BracketRight, Qt::AltModifier);
        QCOMPARE(compare().composition().wipeAngle, 5.0);
        press(Qt::Key_4, Qt::ControlModifier);
        QCOMPARE(compare().composition().mode, Mode::Blend);
        press(Qt::Key_BracketRight);
        QVERIFY(std::abs(compare().composition().blend - 0.55) < 1e-9);
        press(Qt::Key_5, Qt::ControlModifier);
        QCOMPARE(compare().composition().mode, Mode::Difference);
        press(Qt::Key_BracketRight);
        QCOMPARE(compare().composition().gain, 8.0);
        const auto methods = m_window->viewport().shownMethods();
        press(Qt::Key_X);
        QCOMPARE(m_window->viewport().shownMethods(), (std::vector{methods[1], methods[0]}));
        press(Qt::Key_2, Qt::ControlModifier);
        QCOMPARE(compare().composition().mode, Mode::SideBySide);
        press(Qt::Key_1, Qt::ControlModifier);
        QCOMPARE(m_window->viewport().shownMethods(), std::vector{m_window->document().project().method});
        QVERIFY2(m_window->document().undoStack().count() == edits, "comparing is no edit");
    }

    void everythingHasANameAndAnExplanation() {
        compare().setMode(Mode::Wipe);
        for (const char* name : {"compare-single", "compare-side-by-side", "compare-wipe", "compare-blend",
                                 "compare-difference"}) {
            auto* button = m_window->findChild<QToolButton*>(name);
            QVERIFY2(button && button->isVisible(), name);
            QVERIFY(button->focusPolicy() & Qt::TabFocus);
            QVERIFY(!button->accessibleName().isEmpty() && button->toolTip().contains("Ctrl+"));
            QVERIFY2(!button->icon().isNull(), name);
        }
        for (const char* name : {"wipe-position", "wipe-angle"}) {
            auto* field = m_window->findChild<QDoubleSpinBox*>(name);
            QVERIFY2(field && field->isVisible(), name);
            QVERIFY(!field->accessibleName().isEmpty() && !field->toolTip().isEmpty() &&
                    !field->suffix().isEmpty());
        }
        m_window->findChild<QToolButton*>("compare-blend")->click();
        QCOMPARE(compare().composition().mode, Mode::Blend);
        QVERIFY(!m_window->findChild<QDoubleSpinBox*>("wipe-angle")->isVisible());
    }

    void whatEveryShownMethodNeedsIsMade() {
        QCOMPARE(m_window->document().project().method, std::string("view-aligned"));
        QVERIFY(!m_window->frameTextures().texture());
        compare().setPaneCount(3);
        compare().setMode(Mode::SideBySide);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->frameTextures().isFinal(), 60'000);
        QVERIFY(settle());
        QVERIFY(m_window->paints().state(0).levelsAreFinal);
        QVERIFY(m_window->objectTextures().isFinal() && m_window->objectTextures().textures().at(0));
        QCOMPARE(m_window->frameTextures().texture()->width, m_window->viewport().pixels().width());
        QVERIFY(m_window->viewport().pixels().width() < m_window->viewport().width() / 2);
        // What nobody sees any more is not made: another view brings no other texture.
        compare().setMode(Mode::Single);
        const int made = m_window->frameTextures().synthesisCount();
        m_window->viewport().frameAll();
        scene::Camera camera = m_window->viewport().camera();
        camera.azimuth += 20;
        m_window->viewport().moveCamera(camera);
        QVERIFY(settle());
        QCOMPARE(m_window->frameTextures().synthesisCount(), made);
    }

    void aStopThatIsDraggedRecoloursEveryPaneWithoutSynthesis() {
        compare().setPaneCount(3);
        compare().setMode(Mode::SideBySide);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->frameTextures().isFinal(), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->objectTextures().isFinal(), 60'000);
        QVERIFY(settle());
        const auto made = [&] {
            return std::vector{
                m_window->paints().synthesisCount(), m_window->frameTextures().synthesisCount(),
                m_window->objectTextures().synthesisCount(), m_window->viewPlans().planCount()};
        };
        const std::vector<int> before = made();
        widgets::ColorPathView& colors = *m_window->gradientDock().colorView();
        colors.findChild<QToolButton*>("preset-3")->click();
        widgets::ColorPathBar& bar = *colors.bar();
        const auto paint = [&](glm::vec3 color) {
            for (int stop = 0; stop < int(bar.path().stops.size()); ++stop) {
                bar.select(stop);
                bar.recolorSelected(color);
            }
            return m_window->viewport().picture();
        };
        const QImage red = paint({0.8F, 0.2F, 0.2F}), blue = paint({0.2F, 0.2F, 0.8F});
        for (int pane = 0; pane < 3; ++pane) {
            const double from = pane / 3.0, to = (pane + 1) / 3.0;
            QVERIFY2(warmth(red, from, to) > warmth(blue, from, to) + 60,
                     qPrintable(QString("pane %1: %2 and %3")
                                    .arg(pane)
                                    .arg(warmth(red, from, to))
                                    .arg(warmth(blue, from, to))));
        }
        QCOMPARE(made(), before);
    }

    void labelsTellTimeAndErrors() {
        compare().setMode(Mode::SideBySide);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->metrics().viewMeasures().measure(1), 60'000);
        QTRY_VERIFY(compare().view().label(1).text().contains(" ms"));
        for (std::size_t pane = 0; pane < 2; ++pane) {
            const QString text = compare().view().label(pane).text();
            QVERIFY2(text.contains("similarity 0.") && text.contains("shading 0."), qPrintable(text));
        }
        QVERIFY(compare().view().label(0).text().startsWith("Image-based"));
        QVERIFY(compare().view().label(1).text().startsWith("View-aligned"));
        QVERIFY2(m_window->metrics().figuresText().isEmpty(), "each picture has its own");
        QTRY_VERIFY(m_window->frameText().startsWith("Image-based / View-aligned"));
        QTRY_VERIFY_WITH_TIMEOUT(m_window->jobs().isIdle(), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->metrics().viewMeasures().measure(1), 60'000);
        const double one = m_window->metrics().viewMeasures().measure(0)->similarity.mean;
        const double other = m_window->metrics().viewMeasures().measure(1)->similarity.mean;
        QVERIFY(one != other);
        // Each is what the method shown alone gets in a picture of that size, and a wipe's line changes
        // nothing.
        compare().setMode(Mode::Wipe);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->metrics().viewMeasures().measure(1), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->jobs().isIdle(), 60'000);
        press(Qt::Key_BracketRight);
        QVERIFY(m_window->metrics().viewMeasures().measure(1));
    }

    void heatMapsLieOverTheirOwnPictures() {
        compare().setMode(Mode::SideBySide);
        QVERIFY(settle());
        m_window->metrics().heatMaps().similarityAction()->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(m_window->metrics().viewMeasures().isMapFinal(), 60'000);
        const auto maps = m_window->metrics().viewMeasures().heatMaps();
        QCOMPARE(maps.size(), 2U);
        QCOMPARE(maps[0]->picture.size(), m_window->viewport().pixels());
        QCOMPARE(maps[0]->most, maps[1]->most);
        auto* overlay = m_window->metrics().heatMaps().overlay();
        const auto panes = m_window->viewport().panes();
        const auto reading = overlay->reading(panes[1].rect.center());
        QVERIFY(reading);
        QCOMPARE(reading->pane, 1U);
        const QPoint middle(maps[1]->values.width() / 2, maps[1]->values.height() / 2);
        QCOMPARE(reading->value, maps[1]->values(middle.x(), middle.y()));
        m_window->metrics().heatMaps().similarityAction()->trigger();
    }

    void theDocumentsMethodIsSeen() {
        compare().setMode(Mode::Wipe);
        QCOMPARE(m_window->viewport().shownMethods(),
                 (std::vector<std::string>{"image-based", "view-aligned"}));
        press(Qt::Key_1);  // which is seen already
        QCOMPARE(m_window->viewport().shownMethods(),
                 (std::vector<std::string>{"image-based", "view-aligned"}));
        press(Qt::Key_3);
        QCOMPARE(m_window->viewport().shownMethods(),
                 (std::vector<std::string>{"view-dependent", "view-aligned"}));
        compare().setMethod(1, "view-dependent");
        QCOMPARE(m_window->viewport().shownMethods(),
                 (std::vector<std::string>{"view-aligned", "view-dependent"}));
        QVERIFY(settle());
    }

    void theChoiceIsRemembered() {
        compare().setMode(Mode::Wipe);
        compare().setMethod(0, "view-dependent");
        press(Qt::Key_BracketRight, Qt::AltModifier);
        const widgets::Composition chosen = compare().composition();
        m_window->document().undoStack().setClean();
        m_window.reset();
        m_window = std::make_unique<MainWindow>();
        QCOMPARE(compare().composition(), chosen);
        QCOMPARE(m_window->viewport().shownMethods(), chosen.methods);
        // A broken settings file is no reason to fail.
        m_window.reset();
        QSettings().setValue("compare/mode", "sideways");
        QSettings().setValue("compare/methods", QStringList{"no-method", "view-dependent"});
        QSettings().setValue("compare/gain", "much");
        m_window = std::make_unique<MainWindow>();
        QCOMPARE(compare().composition().mode, Mode::Single);
        QVERIFY(compare().composition().gain >= 1);
        QCOMPARE(compare().composition().methods,
                 (std::vector<std::string>{"view-aligned", "image-based"}));  // the document's own first
    }
};

QTEST_MAIN(CompareToolsTest)
#include "compare_tools_test.moc"
