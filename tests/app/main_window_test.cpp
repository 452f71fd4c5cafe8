#include "app/main_window.h"

#include "app/docks/gradient_dock.h"
#include "app/docks/metric_graph_dock.h"
#include "app/docks/sample_dock.h"
#include "app/docks/view_planning_dock.h"
#include "app/export_dialog.h"
#include "app/heat_maps.h"
#include "app/metric_tools.h"
#include "app/picture_export.h"
#include "app/project_collector.h"
#include "app/project_pictures.h"
#include "app/recent_files.h"
#include "core/base/atomic_file.h"
#include "core/project/pipeline.h"
#include "tests/app/app_support.h"
#include "tests/app/window_support.h"
#include "widgets/color_path_bar.h"
#include "widgets/color_path_view.h"
#include "widgets/message_bar.h"
#include "widgets/viewport/heat_overlay.h"
#include "widgets/viewport/overlay_views.h"
#include "widgets/viewport/viewport.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using app::MainWindow;
using test::openAndSettle;

namespace {

/// In steps of 1/255; the pictures are equally large.
double meanDifference(const QImage& a, const QImage& b) {
    double difference = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            difference += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
    return difference / (double(a.width()) * a.height());
}

/// Mean red minus blue over the picture's middle.
double warmth(const QImage& picture) {
    double sum = 0;
    int count = 0;
    for (int y = picture.height() * 2 / 5; y < picture.height() * 3 / 5; y += 2)
        for (int x = picture.width() * 2 / 5; x < picture.width() * 3 / 5; x += 2, ++count)
            sum += qRed(picture.pixel(x, y)) - qBlue(picture.pixel(x, y));
    return sum / count;
}

}  // namespace

class MainWindowTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

    std::vector<std::filesystem::path> stripAndMesh() {
        return {test::writeStrip(m_folder / "strip.png", 320, 96),
                test::writeTetrahedron(m_folder / "mesh.obj", "tetrahedron")};
    }

private Q_SLOTS:
    void initTestCase() { test::prepareWindows(m_folder); }

    void draggingAStopRecoloursTheViewportWithoutSynthesis() {
        MainWindow window;
        window.resize(1200, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(openAndSettle(window, stripAndMesh()));
        window.viewport().frameAll();
        const int made = window.paints().synthesisCount();
        widgets::ColorPathView& colors = *window.gradientDock().colorView();
        colors.findChild<QToolButton*>("preset-3")->click();
        widgets::ColorPathBar& bar = *colors.bar();
        bar.select(int(bar.path().stops.size()) - 1);
        bar.recolorSelected({1, 0, 0});
        bar.select(1);
        bar.recolorSelected({1, 0, 0});
        const double red = warmth(window.viewport().picture());
        bar.recolorSelected({0, 0, 1});
        bar.select(int(bar.path().stops.size()) - 1);
        bar.recolorSelected({0, 0, 1});
        const double blue = warmth(window.viewport().picture());
        QVERIFY2(red > blue + 40, qPrintable(QString("red %1, blue %2").arg(red).arg(blue)));
        QVERIFY(window.jobs().isIdle());
        QCOMPARE(window.paints().synthesisCount(), made);
    }

    void aDraggedStopIsInTheNextFrame_data() {
        QTest::addColumn<QString>("method");
        for (const char* method : {"image-based", "view-aligned", "view-dependent"})
            QTest::newRow(method) << method;
    }

    void aDraggedStopIsInTheNextFrame() {
        QFETCH(QString, method);
        MainWindow window;
        window.resize(1200, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.metrics().heatMaps().liveAction()->setChecked(false);
        QVERIFY(openAndSettle(window, stripAndMesh()));
        window.document().editMethod(method.toStdString());
        window.viewport().frameAll();
        QVERIFY(test::settle(window));
        widgets::ColorPathView& colors = *window.gradientDock().colorView();
        colors.findChild<QToolButton*>("preset-3")->click();
        widgets::ColorPathBar& bar = *colors.bar();
        QVERIFY(bar.path().stops.size() > 2);
        const auto begun = [&] {
            return window.paints().synthesisCount() + window.frameTextures().synthesisCount() +
                   window.objectTextures().synthesisCount() + window.viewPlans().planCount();
        };
        const int before = begun();
        QImage shown = window.viewport().picture();
        const QPoint grip = bar.handle(1).toPoint();
        QTest::mousePress(&bar, Qt::LeftButton, {}, grip);
        for (int step = 1; step <= 5; ++step) {
            const float position = bar.path().stops[1].position;
            const QPoint at = grip + QPoint(8 * step, 0);
            QMouseEvent move(QEvent::MouseMove, at, bar.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(&bar, &move);
            QVERIFY(bar.path().stops[1].position > position);
            const QImage next = window.viewport().picture();
            QVERIFY2(meanDifference(shown, next) > 0.05, "the next frame shows the stop where it was");
            QVERIFY2(window.jobs().isIdle(), "a drag of colours starts a job");
            shown = next;
        }
        QTest::mouseRelease(&bar, Qt::LeftButton, {}, grip + QPoint(40, 0));
        QTest::qWait(500);  // longer than what waits for a drag to rest
        QVERIFY(window.jobs().isIdle());
        QCOMPARE(begun(), before);
        window.metrics().heatMaps().liveAction()->setChecked(true);
    }

    void methodsAreSwitchedByKeyAndButton() {
        MainWindow window;
        window.resize(1200, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.activateWindow();
        QVERIFY(openAndSettle(window, stripAndMesh()));
        const auto method = [&] { return window.document().project().method; };
        QCOMPARE(method(), std::string("view-aligned"));
        const int steps = window.document().undoStack().count();
        const int levels = window.paints().synthesisCount();
        window.viewport().setFocus();
        QTest::keyClick(&window.viewport(), Qt::Key_1);
        QCOMPARE(method(), std::string("image-based"));
        QTRY_VERIFY(window.frameTextures().isFinal());
        QTRY_VERIFY(window.frameText().startsWith("Image-based"));
        auto* button = window.findChild<QToolButton*>("method-view-aligned");
        QVERIFY(button && button->isVisible() && !button->isChecked());
        QVERIFY(button->focusPolicy() & Qt::TabFocus);
        QVERIFY(!button->toolTip().isEmpty());
        button->click();
        QCOMPARE(method(), std::string("view-aligned"));
        QTRY_VERIFY(window.frameText().startsWith("View-aligned"));
        QCOMPARE(window.document().undoStack().count(), steps + 2);
        window.document().undoStack().undo();
        QCOMPARE(method(), std::string("image-based"));
        QVERIFY(window.findChild<QToolButton*>("method-image-based")->isChecked());
        QVERIFY(window.frameTextures().isFinal());
        QCOMPARE(window.paints().synthesisCount(), levels);
    }

    void aLightDragReshadesAtOnceWithTheSameTexture() {
        MainWindow window;
        window.resize(1200, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(openAndSettle(window, stripAndMesh()));
        window.document().editMethod("image-based");
        window.viewport().frameAll();
        QTRY_VERIFY(window.frameTextures().isFinal());
        const auto texture = window.frameTextures().texture();
        const QImage before = window.viewport().picture();
        window.document().editLight(0, {1, -0.5F, 0.4F});
        const QImage after = window.viewport().picture();
        QCOMPARE(window.frameTextures().texture(), texture);
        QVERIFY(meanDifference(before, after) > 1);
    }

    void aBrokenFileSaysWhyAndWhatWasOpenStays() {
        MainWindow window;
        window.show();
        QVERIFY(openAndSettle(window, stripAndMesh()));
        const project::Project before = window.document().project();
        writeFileAtomically(m_folder / "broken.obj", "f 1/1 2/2 99999999/3\n");
        QVERIFY(openAndSettle(window, {m_folder / "broken.obj"}));
        QVERIFY(window.messages().isVisible());
        QVERIFY(window.messages().text().contains("broken.obj"));
        QCOMPARE(window.document().project(), before);
        window.messages().findChild<QToolButton*>("close")->click();
        QVERIFY(!window.messages().isVisible());
    }

    void viewsAndUncoveredFacesAreMarkedOverTheViewport() {
        MainWindow window;
        window.resize(1200, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(openAndSettle(window, stripAndMesh()));
        auto* overlay = window.findChild<widgets::OverlayViews*>();
        QAction* frames = window.findChild<QAction*>("view-frames");
        QVERIFY(overlay->isHidden());
        QCOMPARE(window.viewPlans().planCount(), 0);
        frames->setChecked(true);
        QTRY_VERIFY(window.viewPlans().plan(0));
        QTRY_VERIFY(overlay->isVisible());
        QCOMPARE(overlay->size(), window.viewport().size());
        frames->setChecked(false);
        QVERIFY(overlay->isHidden());
        QVERIFY(!window.viewPlans().isWanted());
        window.viewPlanningDock().raise();
        QTRY_VERIFY(window.viewPlans().isWanted());
    }

    void theTitleTellsNameAndChanges() {
        MainWindow window;
        QVERIFY(openAndSettle(window, stripAndMesh()));
        QVERIFY(window.isWindowModified());
        window.document().save(m_folder / "study.chiaro");
        QVERIFY(!window.isWindowModified());
        QCOMPARE(window.windowTitle(), "study[*] — Chiaro");
        window.document().undoStack().undo();
        QVERIFY(window.isWindowModified());
    }

    void filesAreDroppedOnTheWindow() {
        MainWindow window;
        window.show();
        QMimeData files;
        QList<QUrl> urls;
        for (const auto& path : stripAndMesh())
            urls << QUrl::fromLocalFile(QString::fromStdString(path.string()));
        files.setUrls(urls);
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop({10, 10}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window, &drop);
        QVERIFY(QTest::qWaitFor([&] { return window.jobs().isIdle(); }, 60'000));
        QCOMPARE(window.document().project().samples.size(), 1U);
        QVERIFY(!window.document().project().meshes.empty());
    }

    void cancellingLeavesNothingRunning() {
        MainWindow window;
        window.show();
        window.open({QString::fromStdString(test::writeStrip(m_folder / "strip.png", 640, 160).string()),
                     QString::fromStdString(test::writeTetrahedron(m_folder / "mesh.obj", "one").string())});
        QVERIFY(QTest::qWaitFor([&] { return window.paints().synthesisCount() > 0; }, 60'000));
        QElapsedTimer timer;
        timer.start();
        window.jobs().cancelAll();
        QVERIFY(window.jobs().isIdle());
        QVERIFY(timer.elapsed() < 200);
    }

    void anExportedPictureLooksAsTheViewportDoes_data() {
        QTest::addColumn<QString>("method");
        QTest::newRow("image-based") << "image-based";
        QTest::newRow("view-aligned") << "view-aligned";
    }

    void anExportedPictureLooksAsTheViewportDoes() {
        QFETCH(QString, method);
        MainWindow window;
        window.resize(1200, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(openAndSettle(window, stripAndMesh()));
        window.document().editMethod(method.toStdString());
        QVERIFY(QTest::qWaitFor([&] { return window.jobs().isIdle(); }, 60'000));
        if (method == "image-based") QTRY_VERIFY(window.frameTextures().isFinal());
        const QImage shown = window.viewport().picture();
        const auto model = app::LoadedModel::read(m_folder / "mesh.obj", {});
        app::PictureSource source{window.document().project(),
                                  project::makeScene(window.document().project(), {model.meshes}),
                                  window.viewport().camera(),
                                  {{window.paints().state(0).levels, window.paints().gradient(0)}},
                                  window.viewport().placements(),
                                  shown.width(),
                                  shown.height()};
        app::PictureSettings settings;
        settings.path = m_folder / "picture.png";
        settings.width = shown.width();
        settings.height = shown.height();
        settings.transparent = false;
        const QColor corner = shown.pixelColor(3, shown.height() - 3);
        settings.background = {float(corner.redF()), float(corner.greenF()), float(corner.blueF())};
        app::exportPicture(source, settings, {});
        const QImage picture(QString::fromStdString(settings.path.string()));
        QCOMPARE(picture.size(), shown.size());
        const double difference = meanDifference(shown, picture);
        qInfo("mean difference %.3f of 255", difference);
        QVERIFY2(difference < 2, "the export shows something else than the viewport");
    }

    void savedProjectsAreRememberedWithTheirPictures() {
        MainWindow window;
        window.resize(1000, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(openAndSettle(window, stripAndMesh()));
        const QString path = QString::fromStdString((m_folder / "seen.chiaro").string());
        QVERIFY(app::ProjectPictures::find(path).isNull());
        window.document().save(path.toStdString());
        QTRY_VERIFY_WITH_TIMEOUT(!app::ProjectPictures::find(path).isNull(), 20'000);
        const QImage picture = app::ProjectPictures::find(path);
        QCOMPARE(picture.size(), app::ProjectPictures::size * 2);
        QFile::remove(app::ProjectPictures::file(path));
        QVERIFY(openAndSettle(window, {m_folder / "seen.chiaro"}));
        QTRY_VERIFY_WITH_TIMEOUT(!app::ProjectPictures::find(path).isNull(), 20'000);
        auto* recent = window.findChild<app::RecentFiles*>();
        Q_EMIT recent->aboutToShow();
        QCOMPARE(recent->actions().front()->text(), QString("seen.chiaro"));
        QCOMPARE(recent->actions().front()->icon().pixmap(80, 50).toImage().isNull(), false);
        writeFileAtomically(app::ProjectPictures::file(path).toStdString(), "no picture");
        Q_EMIT recent->aboutToShow();
        QFile::remove(app::ProjectPictures::file(path));
    }

    void allFilesAreCollectedIntoAFolder() {
        MainWindow window;
        window.show();
        QVERIFY(openAndSettle(window, stripAndMesh()));
        window.document().save(m_folder / "study.chiaro");
        auto* collector = window.findChild<app::ProjectCollector*>();
        QSignalSpy collected(collector, &app::ProjectCollector::collected);
        collector->collectInto(m_folder / "all");
        QVERIFY(collected.wait(20'000));
        QVERIFY(collected[0][0].toString().contains("all"));
        QVERIFY(std::filesystem::exists(m_folder / "all/scans/strip.png"));
        QVERIFY(std::filesystem::exists(m_folder / "all/meshes/mesh.obj"));
        QCOMPARE(project::readProject(m_folder / "all/study.chiaro").meshes.size(), 1U);
        QCOMPARE(window.document().path(), m_folder / "study.chiaro");
        // Once more it asks, and takes no for an answer.
        writeFileAtomically(m_folder / "all/study.chiaro", "mine");
        bool asked = false;
        test::answerNext(QMessageBox::Cancel, asked);
        collector->collectInto(m_folder / "all");
        QTRY_VERIFY(asked);
        QVERIFY(QTest::qWaitFor([&] { return window.jobs().isIdle(); }, 10'000));
        QCOMPARE(readFile(m_folder / "all/study.chiaro", 100), std::string("mine"));
        QCOMPARE(collected.count(), 1);
    }

    void aReadOnlyProjectIsNotSavedInPlace() {
        writeFileAtomically(m_folder / "newer.chiaro", R"({"chiaro": 3, "samples": [], "brushes": 1})");
        MainWindow window;
        window.show();
        QVERIFY(openAndSettle(window, {m_folder / "newer.chiaro"}));
        QVERIFY(window.windowTitle().contains("newer (read-only)"));
        QVERIFY(window.findChild<widgets::MessageBar*>()->text().contains("newer Chiaro"));
        QAction* save = nullptr;
        for (QAction* action : window.findChildren<QAction*>())
            if (action->text() == "&Save") save = action;
        QVERIFY(save && !save->isEnabled());
        window.document().save(m_folder / "older.chiaro");
        QVERIFY(save->isEnabled());
    }

    void exportingAPictureAsksBeforeItReplaces() {
        writeFileAtomically(m_folder / "there.png", "mine");
        app::PictureSettings suggested;
        suggested.path = m_folder / "there.png";
        app::ExportDialog dialog(suggested, nullptr);
        QVERIFY(test::asksBeforeItReplaces(dialog));
    }

    void whatTheViewportShowsIsMeasured() {
        MainWindow window;
        window.resize(1200, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(openAndSettle(window, stripAndMesh()));
        QTRY_VERIFY_WITH_TIMEOUT(window.metrics().viewMeasures().measure(), 20'000);
        QVERIFY2(window.metrics().figuresText().contains("similarity 0."),
                 qPrintable(window.metrics().figuresText()));
        const double before = window.metrics().viewMeasures().measure()->similarity.mean;
        scene::Camera camera = window.viewport().camera();
        camera.azimuth += 40;
        window.viewport().setCamera(camera);
        QVERIFY2(!window.metrics().viewMeasures().measure() && window.metrics().figuresText().isEmpty(),
                 "figures of another view are not shown");
        QTRY_VERIFY_WITH_TIMEOUT(window.metrics().viewMeasures().measure(), 20'000);
        QVERIFY(window.metrics().viewMeasures().measure()->similarity.mean != before);

        QAction* map = window.metrics().heatMaps().similarityAction();
        QVERIFY(!window.metrics().heatMaps().overlay()->isVisible());
        map->trigger();
        QVERIFY(window.metrics().heatMaps().overlay()->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(window.metrics().viewMeasures().isMapFinal(), 60'000);
        QCOMPARE(window.metrics().viewMeasures().heatMap()->picture.size(), window.viewport().pixels());
        window.metrics().heatMaps().shadingAction()->trigger();
        QVERIFY(!map->isChecked());
        QCOMPARE(window.metrics().viewMeasures().heatMap()->title, QString("Shading error"));
        window.viewport().frameAll();
        QTRY_VERIFY_WITH_TIMEOUT(window.metrics().viewMeasures().isMapFinal(), 60'000);
        window.metrics().heatMaps().shadingAction()->trigger();
        QVERIFY(!window.metrics().heatMaps().overlay()->isVisible());
        window.metrics().heatMaps().liveAction()->setChecked(false);
        QVERIFY(window.metrics().figuresText().isEmpty());
        window.metrics().heatMaps().liveAction()->setChecked(true);
        window.document().undoStack().setClean();
    }

    void aFrameOfTheComparisonIsShown() {
        MainWindow window;
        window.resize(1200, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(openAndSettle(window, stripAndMesh()));
        scene::Camera wanted = window.viewport().camera();
        const scene::Camera kept = window.document().project().camera;
        wanted.azimuth += 30;
        Q_EMIT window.metrics().dock().cameraWanted(wanted);
        QCOMPARE(window.viewport().camera().azimuth, wanted.azimuth);
        QVERIFY2(window.document().project().camera == kept, "looking at a frame edits nothing");
        window.document().undoStack().setClean();
    }
};

QTEST_MAIN(MainWindowTest)
#include "main_window_test.moc"
