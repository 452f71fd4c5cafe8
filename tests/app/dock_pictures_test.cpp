#include "app/heat_maps.h"
#include "app/job_model.h"
#include "app/metric_tools.h"
#include "app/theme.h"
#include "tests/app/app_support.h"
#include "tests/app/window_support.h"

#include <QtTest>
#include <QtWidgets>

#include <algorithm>

using namespace chiaro;
using app::MainWindow;

namespace {

/// A pixel that differs by more in some channel counts: another version of the font renderer moves the edges
/// of letters by less.
constexpr int largestStep = 40;  ///< of 255
/// Of all pixels. A word more or less in a dock is some 300 pixels of 200,000.
constexpr double largestShare = 0.001;

/// Side by side: of a dock at the window's side, and of one below.
constexpr QSize sideSize(340, 560);
constexpr QSize bottomSize(900, 300);

double differingShare(const QImage& a, const QImage& b) {
    qint64 count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            const int step = std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                                       std::abs(qBlue(p) - qBlue(q))});
            if (step > largestStep) ++count;
        }
    return double(count) / (double(a.width()) * a.height());
}

}  // namespace

/// Every dock against a picture of it that was looked at, in tests/app/baselines. A failure keeps the picture
/// beside the test program. To renew them after a change of a dock: run this with CHIARO_WRITE_BASELINES=1 in
/// the environment, and look at what changed before it is committed.
class DockPicturesTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;
    std::unique_ptr<MainWindow> m_window;

    QImage pictureOf(QDockWidget* dock) const {
        const bool isBelow = m_window->dockWidgetArea(dock) == Qt::BottomDockWidgetArea;
        dock->setFloating(true);
        dock->show();
        dock->resize(isBelow ? bottomSize : sideSize);
        if (!QTest::qWaitForWindowExposed(dock)) return {};
        QTest::qWait(700);  // what it now wants to show is begun once that rests
        if (!test::settle(*m_window)) return {};
        for (QAbstractItemView* list : dock->findChildren<QAbstractItemView*>())
            if (auto* jobs = qobject_cast<app::JobModel*>(list->model())) jobs->clearEnded();
        dock->setFocus();
        QTest::qWait(50);
        return dock->widget()->grab().toImage().convertToFormat(QImage::Format_RGB32);
    }

private Q_SLOTS:
    void initTestCase() {
        test::prepareWindows(m_folder);
        const app::ThemeSwitch theme(app::Theme::Dark);
        QFont font("DejaVu Sans");
        font.setPointSizeF(9);  // 12 px at the dots per inch that main() sets
        font.setHintingPreference(QFont::PreferNoHinting);
        font.setStyleStrategy(QFont::NoSubpixelAntialias);
        QApplication::setFont(font);
        QApplication::setCursorFlashTime(0);
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1400, 900);
        // Figures differ in the last digits between processors.
        m_window->metrics().heatMaps().liveAction()->setChecked(false);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QCOMPARE(m_window->devicePixelRatioF(), 1.0);
        QVERIFY(test::openAndSettle(*m_window, {test::resource("demo/demo.chiaro")}));
        QVERIFY(test::settle(*m_window));
    }
    void cleanupTestCase() { m_window.reset(); }

    void looksAsItDid_data() {
        QTest::addColumn<QString>("name");
        for (const QDockWidget* dock : m_window->findChildren<QDockWidget*>())
            QTest::newRow(qPrintable(dock->objectName())) << dock->objectName();
    }

    void looksAsItDid() {
        QFETCH(QString, name);
        if (!QFontInfo(QFont("DejaVu Sans")).family().contains("DejaVu")) QSKIP("the font is not installed");
        auto* dock = m_window->findChild<QDockWidget*>(name);
        const QImage picture = pictureOf(dock);
        dock->setFloating(false);
        QVERIFY(!picture.isNull());
        const QString file = "dock_" + name + ".png";
        const QString baseline = QString(CHIARO_APP_BASELINES) + "/" + file;
        if (qEnvironmentVariableIsSet("CHIARO_WRITE_BASELINES"))
            QVERIFY(QDir().mkpath(CHIARO_APP_BASELINES) && picture.save(baseline));
        if (QDir(CHIARO_APP_BASELINES).isEmpty()) QSKIP("no pictures of docks were looked at and kept yet");
        const QImage expected(baseline);
        QVERIFY2(!expected.isNull(), qPrintable("there is no " + baseline));
        const bool isSameSize = expected.size() == picture.size();
        const double share = isSameSize ? differingShare(expected, picture) : 1;
        if (share > largestShare) picture.save(file);
        QVERIFY2(share <= largestShare,
                 qPrintable(QString("%1 of the pixels differ, at most %2 may; the picture was kept as %3")
                                .arg(share)
                                .arg(largestShare)
                                .arg(QFileInfo(file).absoluteFilePath())));
    }
};

// Without a display: no setting of the desktop reaches the pictures.
int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("QT_SCALE_FACTOR", "1");
    qputenv("QT_FONT_DPI", "96");
    qputenv("LC_ALL", "C.UTF-8");
    QApplication::setDesktopSettingsAware(false);
    QApplication application(argc, argv);
    DockPicturesTest test;
    QTEST_SET_MAIN_SOURCE_PATH
    return QTest::qExec(&test, argc, argv);
}
#include "dock_pictures_test.moc"
