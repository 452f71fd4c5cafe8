#include "app/main_window.h"

#include "app/docks/gradient_dock.h"
#include "app/docks/sample_dock.h"
#include "app/picture_export.h"
#include "core/base/atomic_file.h"
#include "core/project/pipeline.h"
#include "tests/app/app_support.h"
#include "widgets/color_path_bar.h"
#include "widgets/color_path_view.h"
#include "widgets/message_bar.h"
#include "widgets/viewport/viewport.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;
using app::MainWindow;

namespace {

/// Opens files and waits until all is made and shown.
bool openAndSettle(MainWindow& window, const std::vector<std::filesystem::path>& paths) {
    QStringList names;
    for (const auto& path : paths) names << QString::fromStdString(path.string());
    window.open(names);
    return QTest::qWaitFor([&] { return window.jobs().isIdle(); }, 120'000);
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
    void initTestCase() {
        Q_INIT_RESOURCE(resources);
        QCoreApplication::setOrganizationName("ChiaroTests");
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                           QString::fromStdString(m_folder.path().string()));
    }

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
        QVERIFY(!window.document().project().mesh.empty());
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

    void anExportedPictureLooksAsTheViewportDoes() {
        MainWindow window;
        window.resize(1200, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(openAndSettle(window, stripAndMesh()));
        const QImage shown = window.viewport().picture();
        const auto model = app::LoadedModel::read(m_folder / "mesh.obj", {});
        app::PictureSource source{window.document().project(),
                                  project::makeScene(window.document().project(), model.meshes),
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
        double difference = 0;
        for (int y = 0; y < shown.height(); ++y)
            for (int x = 0; x < shown.width(); ++x)
                difference += std::abs(qGray(shown.pixel(x, y)) - qGray(picture.pixel(x, y)));
        difference /= double(shown.width()) * shown.height();
        qInfo("mean difference %.3f of 255", difference);
        QVERIFY2(difference < 2, "the export shows something else than the viewport");
    }
};

QTEST_MAIN(MainWindowTest)
#include "main_window_test.moc"
