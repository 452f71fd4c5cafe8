#include "app/docks/gradient_dock.h"
#include "app/docks/parameters_dock.h"
#include "app/docks/sample_dock.h"
#include "app/missing_files_dialog.h"
#include "app/preset_menu.h"
#include "core/base/atomic_file.h"
#include "tests/app/app_support.h"
#include "widgets/color_path_bar.h"
#include "widgets/color_path_view.h"
#include "widgets/gradient_curve_editor.h"
#include "widgets/speed_curve_plot.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using test::Studio;

namespace {

/// The docks in a window of their own, wired as the studio's are.
struct Docks {
    Studio studio;
    QMainWindow window;
    app::SampleDock* sample = new app::SampleDock(studio.document, studio.paints);
    app::GradientDock* gradient = new app::GradientDock(studio.document, studio.paints);
    app::ParametersDock* parameters = new app::ParametersDock(studio.document);

    Docks() {
        window.addDockWidget(Qt::LeftDockWidgetArea, sample);
        window.addDockWidget(Qt::RightDockWidgetArea, gradient);
        window.addDockWidget(Qt::LeftDockWidgetArea, parameters);
        QObject::connect(sample, &app::SampleDock::currentSampleChanged, gradient,
                         &app::GradientDock::setSample);
        gradient->setSample(sample->currentSample());
        window.resize(800, 900);
        window.show();
        (void)QTest::qWaitForWindowExposed(&window);
    }
    const project::Sample& current() {
        return studio.document.project().samples[std::size_t(sample->currentSample())];
    }
    QWidget* section(const QString& method, const QString& heading) {
        return parameters->findChild<QWidget*>(method + "/" + heading);
    }
    QUndoStack& undo() { return studio.document.undoStack(); }
};

/// The menu's entry, as it is when the menu opens.
QAction* action(QMenu& menu, const QString& text) {
    Q_EMIT menu.aboutToShow();
    for (QAction* one : menu.actions())
        if (one->text() == text) return one;
    return nullptr;
}

}  // namespace

class DocksTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

private Q_SLOTS:
    void anEmptyProjectShowsEmptyDocks() {
        Docks docks;
        QCOMPARE(docks.sample->currentSample(), -1);
        QVERIFY(!docks.gradient->curveEditor()->isEnabled());
        QVERIFY(!docks.gradient->colorView()->isEnabled());
    }

    void aNewSampleIsShownAndItsRemovalLeavesTheRest() {
        Docks docks;
        QVERIFY(docks.studio.open(
            {test::writeStrip(m_folder / "one.png"), test::writeStrip(m_folder / "two.png")}));
        auto* list = docks.sample->findChild<QListWidget*>("samples");
        QCOMPARE(list->count(), 2);
        list->setCurrentRow(1);
        QCOMPARE(docks.sample->currentSample(), 1);
        QVERIFY(docks.gradient->curveEditor()->isEnabled());
        docks.sample->findChild<QToolButton*>("remove")->click();
        QCOMPARE(list->count(), 1);
        QCOMPARE(docks.sample->currentSample(), 0);
        docks.undo().undo();
        QCOMPARE(list->count(), 2);
    }

    void draggingACurvePointIsOneStepOfTheDocument() {
        Docks docks;
        QVERIFY(docks.studio.open({test::writeStrip(m_folder / "one.png")}));
        const project::Project before = docks.studio.document.project();
        widgets::SpeedCurvePlot& plot = *docks.gradient->curveEditor()->plot();
        docks.gradient->findChild<QToolButton*>("straighten")->click();
        QVERIFY(!docks.current().gradient.matchSpeed);
        QCOMPARE(docks.undo().count(), 2);
        const QPoint place = plot.toWidget({0.5F, 0.25F}).toPoint();
        QTest::mouseDClick(&plot, Qt::LeftButton, {}, place);
        QTest::mouseRelease(&plot, Qt::LeftButton, {}, place);
        QCOMPARE(docks.undo().count(), 3);
        QTest::mousePress(&plot, Qt::LeftButton, {}, place);
        for (int step = 1; step <= 20; ++step) QTest::mouseMove(&plot, place + QPoint(step, -step));
        QTest::mouseRelease(&plot, Qt::LeftButton, {}, place + QPoint(20, -20));
        QCOMPARE(docks.undo().count(), 4);
        QVERIFY(docks.studio.settle());
        while (docks.undo().index() > 1) docks.undo().undo();
        QCOMPARE(docks.studio.document.project(), before);
        QCOMPARE(plot.curve(), docks.studio.paints.state(0).separated->separation.curve);
    }

    void aPresetRecoloursTheSampleAndItsSwatch() {
        Docks docks;
        QVERIFY(docks.studio.open({test::writeStrip(m_folder / "one.png")}));
        auto* list = docks.sample->findChild<QListWidget*>("samples");
        const QImage before = list->item(0)->icon().pixmap(72, 18).toImage();
        docks.gradient->findChild<QToolButton*>("preset-3")->click();
        QVERIFY(docks.current().recoloring.has_value());
        QVERIFY(list->item(0)->icon().pixmap(72, 18).toImage() != before);
        docks.undo().undo();
        QVERIFY(!docks.current().recoloring.has_value());
        QCOMPARE(list->item(0)->icon().pixmap(72, 18).toImage(), before);
        QVERIFY(!docks.gradient->findChild<QCheckBox*>("recolour")->isChecked());
    }

    void samplesAreRenamedInTheList() {
        Docks docks;
        QVERIFY(docks.studio.open(
            {test::writeStrip(m_folder / "one.png"), test::writeStrip(m_folder / "two.png")}));
        auto* list = docks.sample->findChild<QListWidget*>("samples");
        docks.sample->selectSample(1);
        const project::Project before = docks.studio.document.project();
        list->item(1)->setText(" chalk ");
        QTRY_COMPARE(docks.studio.document.project().samples[1].name, std::string("chalk"));
        QTRY_COMPARE(list->item(1)->text(), QString("chalk"));
        QCOMPARE(docks.sample->currentSample(), 1);
        list->item(1)->setText("");
        QTRY_COMPARE(list->item(1)->text(), QString("chalk"));
        docks.undo().undo();
        QCOMPARE(docks.studio.document.project(), before);
        QCOMPARE(list->item(1)->text(), QString("two"));
    }

    void scansAreDroppedOnTheSamples() {
        Docks docks;
        QSignalSpy dropped(docks.sample, &app::Dock::filesDropped);
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile("/scans/oil.png"), QUrl("https://example.org/a.png")});
        QDragEnterEvent enter(QPoint(20, 40), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(docks.sample, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(QPointF(20, 40), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(docks.sample, &event);
        QCOMPARE(dropped[0][0].toStringList(), QStringList{"/scans/oil.png"});
    }

    void missingFilesAreSearchedForInAFolder() {
        test::writeStrip(m_folder / "found/scans/oil.png");
        test::writeTetrahedron(m_folder / "found/meshes/head.obj", "head");
        project::Project project;
        project.samples.resize(1);
        project.samples[0].name = "oil";
        project.samples[0].scan = m_folder / "lost/oil.png";
        project.meshes = {{m_folder / "lost/head.obj"}, {m_folder / "lost/gone.obj"}};
        app::MissingFilesDialog dialog(project);
        dialog.show();
        QCOMPARE(dialog.list()->topLevelItemCount(), 3);
        QSignalSpy searched(&dialog, &app::MissingFilesDialog::searched);
        dialog.search(QString::fromStdString((m_folder / "found").string()));
        QVERIFY(searched.wait(10'000));
        QCOMPARE(dialog.list()->topLevelItemCount(), 1);
        QCOMPARE(project.samples[0].scan, m_folder / "found/scans/oil.png");
        QCOMPARE(project.meshes[0].path, m_folder / "found/meshes/head.obj");
    }

    void gradientsAreKeptAsPresets() {
        QStandardPaths::setTestModeEnabled(true);
        Docks docks;
        QVERIFY(docks.studio.open({test::writeStrip(m_folder / "one.png")}));
        app::PresetMenu& presets = *docks.gradient->presets();
        std::filesystem::remove_all(presets.folder());
        docks.gradient->findChild<QToolButton*>("preset-3")->click();
        const auto kept = docks.current().recoloring;
        presets.save("Blue & deep");
        docks.gradient->findChild<QToolButton*>("preset-1")->click();
        const int steps = docks.undo().count();
        action(presets, "Blue && deep")->trigger();
        QCOMPARE(docks.current().recoloring, kept);
        QCOMPARE(docks.undo().count(), steps + 1);
        docks.undo().undo();
        QVERIFY(docks.current().recoloring != kept);
        presets.rename("Blue & deep", "Night");
        QVERIFY(action(presets, "Night") != nullptr);
        presets.remove("Night");
        QVERIFY(action(presets, "Night") == nullptr);
    }

    void aBrokenPresetSaysWhatIsWrong() {
        QStandardPaths::setTestModeEnabled(true);
        Docks docks;
        QVERIFY(docks.studio.open({test::writeStrip(m_folder / "one.png")}));
        app::PresetMenu& presets = *docks.gradient->presets();
        std::filesystem::remove_all(presets.folder());
        writeFileAtomically(presets.folder() / "torn.json", "{\"chiaro-preset\": 1, ");
        QSignalSpy failed(docks.gradient, &app::Dock::failed);
        const project::Project before = docks.studio.document.project();
        QVERIFY(action(presets, "torn")->toolTip().contains("torn.json: is not JSON"));
        action(presets, "torn")->trigger();
        presets.save("../outside");
        presets.rename("torn", "");
        presets.remove("nothing");
        QCOMPARE(failed.count(), 4);
        for (const auto& message : failed)
            QVERIFY2(message[0].toString().contains(';'), qPrintable(message[0].toString()));
        QCOMPARE(docks.studio.document.project(), before);
        std::filesystem::remove_all(presets.folder());
    }

    void presetsOfParametersAreThoseOfTheMethod() {
        QStandardPaths::setTestModeEnabled(true);
        Docks docks;
        app::PresetMenu& presets = *docks.parameters->presets();
        std::filesystem::remove_all(presets.folder());
        app::Document& document = docks.studio.document;
        document.editMethod("image-based");
        methods::ImageBasedParams params = document.project().imageBased;
        params.window = 9;
        document.editImageBased(params);
        document.finishEdit();
        presets.save("wide");
        document.editImageBased({});
        document.editMethod("view-aligned");
        QVERIFY(action(presets, "wide") == nullptr);
        document.editMethod("image-based");
        action(presets, "wide")->trigger();
        QCOMPARE(document.project().imageBased.window, 9);
        document.undoStack().undo();
        QCOMPARE(document.project().imageBased, methods::ImageBasedParams());
        std::filesystem::remove_all(presets.folder());
    }

    void addMoveDeleteOfAStopAndAPointGivesBackTheProject() {
        Docks docks;
        QVERIFY(docks.studio.open({test::writeStrip(m_folder / "one.png")}));
        docks.gradient->findChild<QToolButton*>("preset-3")->click();
        gradient::GradientParams params = docks.current().gradient;
        params.matchSpeed = false;
        docks.studio.document.editGradient(0, params);
        docks.studio.document.finishEdit();
        const project::Project before = docks.studio.document.project();
        widgets::ColorPathBar& bar = *docks.gradient->colorView()->bar();
        QTest::mouseClick(&bar, Qt::LeftButton, Qt::ControlModifier, {int(bar.toWidget(0.6F)), 10});
        QTest::keyClick(&bar, Qt::Key_Right);
        QVERIFY(docks.studio.document.project() != before);
        QTest::keyClick(&bar, Qt::Key_Delete);
        QCOMPARE(docks.studio.document.project(), before);
        widgets::SpeedCurvePlot& plot = *docks.gradient->curveEditor()->plot();
        QTest::keyClick(&plot, Qt::Key_Insert);
        QTest::keyClick(&plot, Qt::Key_Up);
        QVERIFY(docks.studio.document.project() != before);
        QTest::keyClick(&plot, Qt::Key_Delete);
        QCOMPARE(docks.studio.document.project(), before);
    }

    void fitIntoAColumnOf340Pixels() {
        Docks docks;
        QVERIFY(docks.studio.open({test::writeStrip(m_folder / "one.png")}));
        for (QDockWidget* dock :
             std::initializer_list<QDockWidget*>{docks.sample, docks.gradient, docks.parameters})
            QVERIFY2(dock->minimumSizeHint().width() <= 340, qPrintable(dock->objectName()));
    }

    void parametersReachTheProjectAndComeBackWithUndo() {
        Docks docks;
        for (const char* method : {"image-based", "view-aligned", "view-dependent"}) {
            docks.studio.document.editMethod(method);
            docks.studio.document.finishEdit();
            auto* block = docks.section(method, "Quilting")->findChild<QDoubleSpinBox*>("block");
            const auto inProject = [&] {
                const project::Project& project = docks.studio.document.project();
                return (project.method == "image-based" ? project.imageBased.quilt : project.levels.quilt)
                    .block;
            };
            const double before = block->value();
            block->selectAll();
            QTest::keyClicks(block, "24");
            QTest::keyClick(block, Qt::Key_Return);
            QCOMPARE(inProject(), 24);
            docks.undo().undo();
            QCOMPARE(block->value(), before);
        }
    }

    void theParametersAreThoseOfTheMethod() {
        Docks docks;
        docks.studio.document.editMethod("image-based");
        for (const char* heading : {"Synthesis", "Quilting", "Coherence"})
            QVERIFY(docks.section("image-based", heading)->isVisible());
        for (const char* heading : {"Strokes", "Levels", "Quilting"})
            QVERIFY(!docks.section("view-aligned", heading)->isVisible());
        docks.undo().undo();
        QVERIFY(!docks.section("image-based", "Synthesis")->isVisible());
        QVERIFY(docks.section("view-aligned", "Strokes")->isVisible());
    }

    void theViewDependentMethodHasItsOwn() {
        Docks docks;
        app::Document& document = docks.studio.document;
        document.editMethod("view-dependent");
        document.finishEdit();
        for (const char* heading : {"Blending", "Views", "Levels", "Quilting"})
            QVERIFY(docks.section("view-dependent", heading)->isVisible());
        // Of the levels only what its textures are made from.
        synthesis::LevelParams levels = document.project().levels;
        levels.size = 77;
        document.editLevels(levels);
        document.finishEdit();
        const QWidget* section = docks.section("view-dependent", "Levels");
        QVERIFY(!section->findChild<QWidget*>("size") && !section->findChild<QWidget*>("tiling"));
        auto* count = section->findChild<QDoubleSpinBox*>("count");
        count->selectAll();
        QTest::keyClicks(count, "5");
        QTest::keyClick(count, Qt::Key_Return);
        levels.count = 5;
        QCOMPARE(document.project().levels, levels);
        auto* views = docks.section("view-dependent", "Views")->findChild<QDoubleSpinBox*>("count");
        views->selectAll();
        QTest::keyClicks(views, "9");
        QTest::keyClick(views, Qt::Key_Return);
        QCOMPARE(document.project().views.count, 9);
        docks.undo().undo();
        QCOMPARE(document.project().views.count, views::ViewParams{}.count);
        docks.section("view-dependent", "Blending")->findChild<QCheckBox*>("follow-camera")->click();
        QVERIFY(document.project().viewDependent.followCamera);
        docks.undo().undo();
        QVERIFY(!document.project().viewDependent.followCamera);
    }

    void coherenceIsEditedInOneStepADragAndSynthesisesNothing() {
        Docks docks;
        docks.studio.document.editMethod("image-based");
        docks.studio.document.finishEdit();
        const methods::CoherenceParams before = docks.studio.document.project().coherence;
        const int steps = docks.undo().count();
        auto* slider = docks.section("image-based", "Coherence")->findChild<QSlider*>();
        QVERIFY(slider);
        slider->setSliderDown(true);
        for (int i = 1; i <= 10; ++i) slider->setSliderPosition(slider->minimum() + 3 * i);
        slider->setSliderDown(false);
        QVERIFY(docks.studio.document.project().coherence != before);
        QCOMPARE(docks.undo().count(), steps + 1);
        docks.undo().undo();
        QCOMPARE(docks.studio.document.project().coherence, before);
        QVERIFY(docks.studio.jobs.isIdle());
    }

    void loadingTheDemoNeverHoldsTheWindowUp() {
        QVERIFY2(std::filesystem::exists(test::resource("demo/demo.chiaro")), "the demo is missing");
        // Other programs may hold it up as well: the best of three counts.
        qint64 longest = std::numeric_limits<qint64>::max();
        for (int attempt = 0; attempt < 3 && longest >= 50; ++attempt) {
            Docks docks;
            const test::Watchdog watchdog;
            QVERIFY(docks.studio.open({test::resource("demo/demo.chiaro")}));
            QVERIFY(docks.studio.errors.empty());
            QVERIFY(docks.studio.paints.state(docks.sample->currentSample()).levelsAreFinal);
            qInfo("longest time without an event: %lld ms", watchdog.longest());
            longest = std::min(longest, watchdog.longest());
        }
        QVERIFY2(longest < 50, "loading or synthesis holds the window up");
    }
};

QTEST_MAIN(DocksTest)
#include "docks_test.moc"
