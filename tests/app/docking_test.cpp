#include "tests/app/app_support.h"
#include "tests/app/window_support.h"
#include "widgets/viewport/viewport.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
#include <QtTest>
#include <QtWidgets>

#include <fstream>
#include <unistd.h>

using namespace chiaro;
using app::MainWindow;

namespace {

constexpr int cycles = 100;
/// What caches and the allocator may still take after the first cycles. A leaked viewport's buffers alone
/// would be several times as much in 80 cycles.
constexpr double largestGrowth = 24;  ///< MB

double residentMegabytes() {
    std::ifstream file("/proc/self/statm");
    long total = 0;
    long resident = 0;
    file >> total >> resident;
    return double(resident) * double(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Errors that OpenGL noted since the last call, in the viewport's context.
int openGlErrors(MainWindow& window) {
    auto* view = window.viewport().findChild<QOpenGLWidget*>();
    if (!view || !view->context()) return 0;
    view->makeCurrent();
    int errors = 0;
    while (view->context()->functions()->glGetError() != GL_NO_ERROR && errors < 100) ++errors;
    view->doneCurrent();
    return errors;
}

void waitForPaint() {
    QTest::qWait(1);
    QCoreApplication::processEvents();
}

}  // namespace

class DockingTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

    void open(MainWindow& window) {
        QSettings().setValue("metric-graph/seen", true);  // else the first look at it makes room for it
        window.resize(1000, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(test::openAndSettle(window, {test::writeStrip(m_folder / "strip.png"),
                                             test::writeTetrahedron(m_folder / "mesh.obj", "tetrahedron")}));
        window.document().undoStack().setClean();
    }

    /// Docks share the room out anew when one comes back: the picture is one of the same size again.
    static QImage pictureIn(MainWindow& window, const QByteArray& layout) {
        window.restoreState(layout);
        QTest::qWait(50);
        test::settle(window);
        return window.viewport().picture();
    }

private Q_SLOTS:
    void initTestCase() {
        test::prepareWindows(m_folder);
        QTest::failOnWarning(QRegularExpression("OpenGL|QPainter|QWidget|QWindow"));
    }

    void floatingDocksChangesNoPicture() {
        MainWindow window;
        open(window);
        const QImage before = window.viewport().picture();
        const QByteArray layout = window.saveState();
        openGlErrors(window);
        const QList<QDockWidget*> docks = window.findChildren<QDockWidget*>();
        double settled = 0;
        for (int cycle = 0; cycle < cycles; ++cycle) {
            QDockWidget* dock = docks[cycle % docks.size()];
            dock->raise();
            dock->setFloating(true);
            waitForPaint();
            QVERIFY(dock->isFloating() && dock->isVisible());
            dock->setFloating(false);
            waitForPaint();
            if (cycle == cycles / 5) settled = residentMegabytes();
        }
        const double growth = residentMegabytes() - settled;
        qInfo("%.1f MB more after %d cycles than after %d", growth, cycles, cycles / 5);
        QVERIFY(test::settle(window));
        for (QDockWidget* dock : docks) QVERIFY(!dock->isFloating());
        QCOMPARE(openGlErrors(window), 0);
        const QImage after = pictureIn(window, layout);
        QCOMPARE(after.size(), before.size());
        QVERIFY2(after == before, "the picture is another");
        QVERIFY2(growth < largestGrowth, "memory is left behind");
    }

    /// As when a compositor or a screen goes: the view gets a new context each time.
    void aNewContextChangesNoPicture() {
        MainWindow window;
        open(window);
        if (!window.viewport().usesOpenGl()) QSKIP("there is no OpenGL here");
        const QImage before = window.viewport().picture();
        const QByteArray layout = window.saveState();
        for (int cycle = 0; cycle < 10; ++cycle) {
            QWidget* center = window.takeCentralWidget();
            center->setParent(nullptr);
            center->resize(300, 200);
            center->show();
            QVERIFY(QTest::qWaitForWindowExposed(center));
            window.setCentralWidget(center);
            waitForPaint();
        }
        QVERIFY(window.viewport().usesOpenGl());
        QCOMPARE(openGlErrors(window), 0);
        const QImage after = pictureIn(window, layout);
        QCOMPARE(after.size(), before.size());
        QVERIFY2(after == before, "the picture is another");
    }
};

// As in the studio: a new context finds the textures of the old one.
int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    DockingTest test;
    QTEST_SET_MAIN_SOURCE_PATH
    return QTest::qExec(&test, argc, argv);
}
#include "docking_test.moc"
