#include "tests/app/app_support.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;

namespace {

/// Mean absolute difference over the middle of the windows, where the mesh is; in steps of 1/255.
double differenceInTheMiddle(const QImage& a, const QImage& b) {
    double sum = 0;
    int count = 0;
    for (int y = a.height() / 3; y < a.height() / 2; ++y)
        for (int x = a.width() * 2 / 5; x < a.width() * 3 / 5; ++x, ++count)
            sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
    return sum / count;
}

int colorsInTheMiddle(const QImage& picture) {
    QSet<QRgb> colors;
    for (int y = picture.height() / 3; y < picture.height() / 2; ++y)
        for (int x = picture.width() * 2 / 5; x < picture.width() * 3 / 5; ++x) colors << picture.pixel(x, y);
    return int(colors.size());
}

}  // namespace

/// The program itself, on machines with less than it likes.
class StudioProgramTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;
    QImage m_usual;

    /// What the studio's window shows with these variables in the environment.
    QImage screenshot(const QStringList& variables) {
        const QString strip = QString::fromStdString(test::writeStrip(m_folder / "strip.png").string());
        const QString mesh =
            QString::fromStdString(test::writeTetrahedron(m_folder / "mesh.obj", "tetrahedron").string());
        const QString file = QString::fromStdString((m_folder / "window.png").string());
        QFile::remove(file);
        QProcess studio;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("HOME", QString::fromStdString(m_folder.path().string()));
        for (const QString& variable : variables)
            environment.insert(variable.section('=', 0, 0), variable.section('=', 1));
        studio.setProcessEnvironment(environment);
        studio.setProcessChannelMode(QProcess::ForwardedChannels);
        studio.start(CHIARO_STUDIO_PROGRAM, {"--screenshot", file, strip, mesh});
        if (!studio.waitForFinished(120'000)) return {};
        if (studio.exitStatus() != QProcess::NormalExit || studio.exitCode() != 0) {
            qWarning("the studio ended with %d", studio.exitCode());
            return {};
        }
        return QImage(file);
    }

private Q_SLOTS:
    void initTestCase() {
        m_usual = screenshot({});
        QVERIFY(!m_usual.isNull());
        QVERIFY2(colorsInTheMiddle(m_usual) > 100, "the picture shows nothing");
    }

    void worksWithLess_data() {
        QTest::addColumn<QStringList>("variables");
        QTest::newRow("no OpenGL") << QStringList{"QT_XCB_GL_INTEGRATION=none"};
        QTest::newRow("no OpenGL driver")
            << QStringList{"LIBGL_DRIVERS_PATH=/nowhere", "LIBGL_ALWAYS_SOFTWARE=1"};
        QTest::newRow("OpenGL 3.3") << QStringList{"MESA_GL_VERSION_OVERRIDE=3.3",
                                                   "MESA_GLSL_VERSION_OVERRIDE=330"};
        QTest::newRow("OpenGL 2.1") << QStringList{"MESA_GL_VERSION_OVERRIDE=2.1"};
        QTest::newRow("no window system") << QStringList{"QT_QPA_PLATFORM=offscreen"};
    }

    void worksWithLess() {
        QFETCH(QStringList, variables);
        const QImage picture = screenshot(variables);
        QVERIFY2(!picture.isNull(), "there is no picture");
        QCOMPARE(picture.size(), m_usual.size());
        const double difference = differenceInTheMiddle(picture, m_usual);
        qInfo("mean difference %.2f of 255, %d colours", difference, colorsInTheMiddle(picture));
        QVERIFY(colorsInTheMiddle(picture) > 100);
        QVERIFY2(difference < 3, "another picture than with OpenGL");
    }
};

QTEST_MAIN(StudioProgramTest)
#include "studio_program_test.moc"
